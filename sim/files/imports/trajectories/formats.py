"""The words of other programs' files of trajectories, in one place: names of columns, tables and units.

- JuPedSim's database (.sqlite), version 2: tables `trajectory_data` (frame, id, pos_x, pos_y, ori_x, ori_y) and `metadata`
  (key, value), of which `fps` is asked for; `geometry` (wkt), where people could walk. Metres.
- JuPedSim's and PedPy's text: comments behind `#`, among them `framerate: 25` and the units, `x/m` or `x/cm`; then id,
  frame, x, y, and more that is not asked for.
- Vadere's footsteps (.traj): a header, columns parted by spaces, whose names end in the number of a processor, as in
  `startX-PID1`; a row is a step from `start` at `simTime` to `end` at `endTime`, both of the body's middle.
- ETH's and UCY's `obsmat`: no header; frame, id, x, z, y, and velocities; annotated 2.5 times a second (S. Pellegrini et
  al., ICCV 2009), ground plane x, y in metres.
- ETH's and UCY's as forecasters hand them around: frame, id, x, y in metres, and UCY's own splines (annotated.py).
- Plain: id, t, x, y, by a header or in this order.
"""

FORMATS = ("jupedsim", "pedpy", "vadere", "obsmat", "frames", "vsp", "plain")
JUPEDSIM, TEXT, VADERE, OBSMAT, FRAMES, SPLINES, PLAIN = FORMATS
SPLINES_BEGIN = "number of splines"
SQLITE_BEGINS = b"SQLite format 3\x00"
TABLE, ROWS, META, FPS = "trajectory_data", ("id", "frame", "pos_x", "pos_y"), "metadata", "fps"
GEOMETRY = "geometry"
RATE, CENTIMETRES = "framerate", ("x/cm", "in cm")
FOOTSTEP = ("pedestrianId", "simTime", "endTime", "startX", "startY", "endX", "endY")
PLACE_OF_FOOTSTEP = ("pedestrianId", "simTime", "startX", "startY")
OBSERVED = (1, 0, 2, 4)
"""Columns of an obsmat: id, frame, x, y."""
ANNOTATED = 2.5
"""Times a second that an obsmat was annotated."""
FILM = 25.0
"""Frames a second of the films in which splines were drawn."""
FRAMED = (1, 0, 2, 3)
"""Columns of a table of frames: id, frame, x, y."""
COLUMNS = ("id", "t", "x", "y")
"""Columns of a plain table."""
TIMES = ("t", "time", "seconds")
"""How a plain table may call the time."""
