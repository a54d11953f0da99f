"""The menu bar, the bar that plays, questions, notices, and the help overlay."""

import os
import shutil
import sys
from pathlib import Path

from imgui_bundle import imgui
from imgui_bundle import portable_file_dialogs as dialogs

from planner.script.scene import scene_names
from sim.files.studio import keeping
from sim.files.studio.document import new_document
from sim.files.studio.keeping import Opened
from sim.view.studio.desk.desk import Desk
from sim.view.studio.desk.keys import ACTIONS

GROUPS = ("document", "footprints", "time", "shape", "play", "view")
FILTER = ["Footfall scenes", "*.toml"]
FIXED = (
    imgui.WindowFlags_.no_move
    | imgui.WindowFlags_.no_resize
    | imgui.WindowFlags_.no_title_bar
    | imgui.WindowFlags_.no_scrollbar
)


def has_dialogs() -> bool:
    """Whether this machine has native file dialogs: on Linux, programs that show them."""
    if os.environ.get("SDL_VIDEODRIVER") == "offscreen":
        return False
    return sys.platform in ("win32", "darwin") or any(shutil.which(one) for one in ("zenity", "kdialog", "matedialog", "qarma"))


class Menus:
    """What the user asks for by name."""

    def __init__(self) -> None:
        self._dialog: tuple[str, dialogs.open_file | dialogs.save_file] | None = None
        self._question, self._then = "", ""
        self._typed: str | None = None
        self.lost = keeping.lost()

    def bar(self, desk: Desk) -> float:
        """The menu bar; returns its height."""
        height = 0.0
        if imgui.begin_main_menu_bar():
            self._file(desk)
            for group in GROUPS[1:]:
                if imgui.begin_menu(group.capitalize()):
                    for action in ACTIONS:
                        if action.group == group and imgui.menu_item(action.words, action.key, False)[0]:
                            action.does(desk)
                    imgui.end_menu()
            self._undone(desk)
            name = desk.opened.path.name if desk.opened.path else "a new scene"
            said = f"{name}{' *' if desk.unsaved else ''}"
            imgui.same_line(imgui.get_window_width() - imgui.calc_text_size(said).x - 1.2 * imgui.get_font_size())
            imgui.text_disabled(said)
            height = imgui.get_window_height()
            imgui.end_main_menu_bar()
        return height

    def _file(self, desk: Desk) -> None:
        if not imgui.begin_menu("Scene"):
            return
        for action in ACTIONS:
            if action.group == "document" and imgui.menu_item(action.words, action.key, False)[0]:
                action.does(desk)
        imgui.separator()
        for title, names in (("recent", keeping.recent()), ("that ship", scene_names())):
            if imgui.begin_menu(title):
                for name in names:
                    if imgui.menu_item(Path(name).name, "", False)[0]:
                        self._ask(desk, f"open:{name}")
                imgui.end_menu()
        imgui.end_menu()

    def _undone(self, desk: Desk) -> None:
        """Everything that was done, by name; a click goes back to it, or on."""
        if not imgui.begin_menu("History"):
            return
        for at in range(len(desk.history.steps) - 1, max(len(desk.history.steps) - 40, -1), -1):
            if imgui.menu_item(f"{desk.history.steps[at].name}##{at}", "", at == desk.history.at)[0]:
                desk.go(at)
        imgui.end_menu()

    def asked(self, desk: Desk) -> None:
        """Does what was asked for, with the questions that it needs."""
        asked, desk.asked = desk.asked, ""
        if asked in ("new", "open", "quit"):
            self._ask(desk, asked)
        elif asked == "save" and desk.opened.path is not None:
            self._save(desk, desk.opened.path, False)
        elif asked in ("save", "save as"):
            self._choose(desk, "save")
        self._answered(desk)
        self._questions(desk)

    def _ask(self, desk: Desk, what: str) -> None:
        """Asks first where work would be lost."""
        if desk.unsaved:
            self._question, self._then = "This scene has not been saved. Go on without?", what
        else:
            self._do(desk, what)

    def _do(self, desk: Desk, what: str) -> None:
        if what == "quit":
            desk.autosave.forget()
            desk.running = False
        elif what == "new":
            desk.autosave.forget()
            desk.take(Opened(new_document(), None))
        elif what == "open":
            self._choose(desk, "open")
        elif what.startswith("open:"):
            desk.trying(lambda: desk.open(what[5:]))
        elif what.startswith("over:"):
            self._save(desk, Path(what[5:]), True)
        elif what == "recover" and self.lost:
            left = self.lost.pop(0)
            if desk.trying(lambda: desk.recover(left)):
                left.unlink(missing_ok=True)

    def _choose(self, desk: Desk, what: str) -> None:
        """A native dialog, or a line to type where there is none."""
        folder = str(desk.opened.path.parent if desk.opened.path else Path.cwd())
        if not has_dialogs():
            self._typed, self._then = folder + "/scene.toml", what
            return
        if what == "open":
            self._dialog = ("open", dialogs.open_file("Open a scene", folder, FILTER))
        else:
            self._dialog = ("save", dialogs.save_file("Save the scene", folder + "/scene.toml", FILTER))

    def _answered(self, desk: Desk) -> None:
        """Takes the answer of a dialog."""
        if self._dialog is None or not self._dialog[1].ready(0):
            return
        (what, dialog), self._dialog = self._dialog, None
        result = dialog.result()
        name = result[0] if isinstance(result, list) and result else result if isinstance(result, str) else ""
        if name:
            self._chosen(desk, what, name)

    def _chosen(self, desk: Desk, what: str, name: str) -> None:
        if what == "open":
            desk.trying(lambda: desk.open(name))
        else:
            self._save(desk, Path(name), True)

    def _named(self, desk: Desk, what: str, path: Path) -> None:
        """As chosen in a dialog; nobody has been asked yet whether a file that is there may be written over."""
        path = path if path.suffix or what == "open" else path.with_suffix(".toml")
        if what == "open" or not path.exists():
            self._chosen(desk, what, str(path))
        elif path.resolve() == desk.opened.path:
            self._save(desk, path.resolve(), False)
        else:
            self._question, self._then = f"{path.name} is there already. Save over it?", f"over:{path}"

    def _save(self, desk: Desk, path: Path, force: bool) -> None:
        """Saves; asks before somebody else's work is lost."""
        if not force and keeping.changed_on_disk(desk.opened) and path == desk.opened.path:
            self._question, self._then = f"{path.name} has been changed by somebody else. Save over it?", f"over:{path}"
            return
        desk.trying(lambda: desk.save(path, force))

    def _questions(self, desk: Desk) -> None:
        """The question that is open."""
        if self.lost and not self._question and not desk.unsaved:
            self._question, self._then = "A scene was left unsaved when the studio ended. Open it?", "recover"
        if self._question and not imgui.is_popup_open("question"):
            imgui.open_popup("question")
        if self._typed is not None and not imgui.is_popup_open("name"):
            imgui.open_popup("name")
        flags = imgui.WindowFlags_.always_auto_resize | imgui.WindowFlags_.no_title_bar
        if imgui.begin_popup_modal("question", None, flags)[0]:
            imgui.text(self._question)
            for label in ("yes", "no"):
                if imgui.button(label, (90, 0)):
                    then, self._question, self._then = self._then, "", ""
                    imgui.close_current_popup()
                    if label == "yes":
                        self._do(desk, then)
                    elif then == "recover":
                        self.lost = self.lost[1:]
                imgui.same_line()
            imgui.end_popup()
        if imgui.begin_popup_modal("name", None, flags)[0]:
            self._name(desk)
            imgui.end_popup()

    def _name(self, desk: Desk) -> None:
        """A file's name, typed."""
        imgui.text("Name of the file")
        if imgui.is_window_appearing():
            imgui.set_keyboard_focus_here()
        changed, text = imgui.input_text("##name", self._typed or "", imgui.InputTextFlags_.enter_returns_true)
        self._typed = text
        done = imgui.button("ok", (90, 0)) or changed
        imgui.same_line()
        if imgui.button("cancel", (90, 0)) or imgui.is_key_pressed(imgui.Key.escape) or done:
            name, what, self._typed = self._typed or "", self._then, None
            imgui.close_current_popup()
            if done and name:
                self._named(desk, what, Path(name).expanduser())
