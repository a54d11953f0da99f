from motion.characters.character import load_character
from motion.motion import solve
from planner.script.footprint import Footprint
from planner.script.laying import laid

human, feet = load_character("human"), [("left", 0.06), ("right", -0.06)] * 4
given = [Footprint(side=side, position=(0.7 * k, y)) for k, (side, y) in enumerate(feet)]
motion = solve(laid(given, human), human)
print(motion.pose(1.5).knee, motion.end)
