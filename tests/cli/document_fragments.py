# SPDX-License-Identifier: BSD-3-Clause
"""What completes the parts of project files in the documents: a base project and files, by document and heading."""
import math
import os
import pathlib

SOURCE = pathlib.Path(os.environ["TRIVET_SOURCE"])
STARTER = "what `trivet new` prints"

FRAME = """trivet = 1
gravity = [0, 0, -9.80665]
[bodies.frame]
mass = "400 kg"
inertia = {about = "center_of_mass", xx = 30, yy = 40, zz = 50}
points.seat = [0.3, 0.2, 0.4]
"""


def mount(name, on, at):
    return f"""[elements."{name}"]
type = "bushing"
on = "{on}"
at = {at}
translation = ["180 N/mm", "180 N/mm", "420 N/mm"]
"""


CORNERS = {
    "front left": [1.4, 0.55, 0],
    "front right": [1.4, -0.55, 0],
    "rear left": [-1.4, 0.55, 0],
    "rear right": [-1.4, -0.55, 0],
}


def mounts(on, foundations=()):
    """Four mounts, each on its foundation."""
    lines = [f'foundation = "{foundation}"\n' for foundation in foundations] or [""] * len(CORNERS)
    return "".join(mount(name, on, at) + line for (name, at), line in zip(CORNERS.items(), lines, strict=True))


def mobility_of_feet():
    """Sets 58 of two ground points, nodes 11 and 12, on springs with a dashpot and a coupling along z."""
    lines = []
    for response, reference, share in ((11, 11, 1), (12, 12, 1), (11, 12, 0.3)):
        values = [share * 2j * math.pi * hertz / (4e6 + 4e4j * math.pi * hertz) for hertz in range(1, 101)]
        lines += ["    -1", "    58", *["NONE"] * 5]
        lines.append(f"{4:5d}{1:10d}{1:5d}{0:10d} {'NONE':10}{response:10d}{3:4d} {'NONE':10}{reference:10d}{3:4d}")
        lines.append(f"{6:10d}{len(values):10d}{1:10d}{1:13.5E}{1:13.5E}{0:13.5E}")
        for quantity in (18, 11, 13, 0):  # frequency, velocity, excitation force
            lines.append(f"{quantity:10d}{0:5d}{0:5d}{0:5d} {'NONE':20} {'NONE':20}")
        lines += [f"{value.real:20.11E}{value.imag:20.11E}" for value in values] + ["    -1"]
    return "\n".join(lines) + "\n"


GENSET = FRAME.replace("frame", "genset")
SHARED_MOUNT = """[element_types.mount]
type = "bushing"
translation = ["1.6 kN/mm", "1.2 kN/mm", "3.4 kN/mm"]
"""
MACHINE_AND_ENGINE = (
    FRAME.replace("frame", "machine")
    + mounts("machine")
    + """[bodies.engine]
mass = "200 kg"
position = [5, 0, 0]
inertia = {about = "center_of_mass", xx = 12, yy = 20, zz = 20}
"""
    + mount("engine mount", "engine", [0, 0, -0.1])
    + 'rotation = ["2 kN m/rad", "2 kN m/rad", "2 kN m/rad"]\n'  # it does not fall over
)
DRIVEN_FRAME = (
    FRAME
    + mounts("frame")
    + mount("front spring", "frame", [0, 0, 0])
    + """[excitations.push]
type = "harmonic"
on = "frame"
at = [0, 0, 0]
force = [0, 0, 100]
[excitations.crank]
type = "orders"
on = "frame"
at = [0, 0, 0]
table = [{order = 2, force_per_speed2 = [0, 0, 0.02]}]
[excitations.road]
type = "random"
base = true
translation = [0, 0, 1]
psd = {road = "C", speed = "80 km/h"}
[excitations.shock]
type = "time"
base = true
quantity = "acceleration"
translation = [0, 0, 1]
history = {half_sine = {amplitude = "50 g", duration = "11 ms"}}
[analyses]
response = {band = ["2 Hz", "60 Hz"], excitations = ["push"]}
"""
)
ON_THE_FRAME = (
    "coil_spring",
    "rubber_disc, rubber_block, rubber_bush, sandwich",
    "solid_mount",
    "beam",
    "link, stay",
    "imported",
    "measured",
    "table, air_spring, wire_rope",
    "catalogue:NAME",
)
KEYS = "docs/project-file.md"

POWERTRAIN = (SOURCE / "examples/powertrain/decoupled.toml").read_text()
ROLL_STOP = (SOURCE / "examples/roll_stop/engine.toml").read_text().split('[elements."roll stop"]')[0]
ON_HYDROMOUNTS = (SOURCE / "examples/hydromount/engine.toml").read_text().replace("gravity", "# gravity")
SUSPENDED = """trivet = 1
[bodies.machine]
mass = 40
free = ["z"]
[elements.suspension]
type = "bushing"
on = "machine"
at = [0, 0, 0]
translation = [1, 1, 2.5e5]
damping = {translation = [1, 1, 400]}
[excitations.push]
type = "harmonic"
on = "machine"
at = [0, 0, 0]
force = [0, 0, 30]
[analyses]
response = {band = ["20 Hz", "40 Hz"]}
"""
MOUNTS = (SOURCE / "examples/genset/mounts.toml").read_text()
PUMP_SET = (SOURCE / "examples/pump_set/pump.toml").read_text().split("[requirements]")[0]
OBSERVED = (SOURCE / "examples/genset/load_cases.toml").read_text().split("[relative")[0]
REQUIRED = (SOURCE / "examples/compressor/requirements.toml").read_text().split("[requirements]")

BASES = {
    ("docs/elements/README.md", "Elements"): FRAME,
    ("docs/elements/catalogue.md", "Catalogues of mounts"): FRAME
    + """[elements.mount]
type = "catalogue:M 50/25 55 ShA"
catalogue = "maker.toml"
on = "frame"
at = [0, 0, 0]
axis = "z"
""",
    ("docs/nonlinear.md", "Laws"): ROLL_STOP,
    ("docs/elements/solid_mount.md", "Nonlinear along an axis"): ROLL_STOP,
    ("docs/elements/table_laws.md", "Wire ropes"): ROLL_STOP,
    ("docs/nonlinear.md", "Stops that rub"): ROLL_STOP,
    ("docs/nonlinear.md", "Struts and rings"): ROLL_STOP,
    ("docs/elements/hydromount.md", "Hydromount"): ON_HYDROMOUNTS.split("[element_types")[0]
    + "[elements.rear]"
    + ON_HYDROMOUNTS.partition("[elements.rear]")[2].partition("[cases")[0],
    ("docs/measurements.md", "Measured and computed curves"): DRIVEN_FRAME,
    ("docs/design.md", "Requirements, the verdict, and the best design"): REQUIRED[0]
    + "[cases."
    + REQUIRED[1].partition("[cases.")[2],
    ("docs/design.md", "Keys, values and margins"): PUMP_SET,
    ("docs/design.md", "Clearances"): OBSERVED,
    ("docs/design.md", "Load cases"): OBSERVED,
    ("docs/analyses.md", "Relative motion"): OBSERVED,
    ("docs/analyses.md", "At the operating speed"): FRAME.replace("frame", "fan").replace("seat", "bearing")
    + mounts("fan")
    + """[excitations.rotor]
type = "unbalance"
on = "fan"
at = [0, 0, 0.2]
axis = "x"
grade = 6.3
rotor_mass = "100 kg"
service_speed = "980 rpm"
""",
    ("docs/analyses.md", "Section forces"): OBSERVED,
    ("docs/design.md", "Parameters"): POWERTRAIN.split("[parameters")[0] + "[requirements]\ndamping_ratio = 0.01\n",
    ("docs/design.md", "Choices of mounts"): MOUNTS,
    ("docs/design.md", "trivet select"): MOUNTS,
    ("docs/design.md", "trivet optimize"): (SOURCE / "examples/paper/corrected.toml").read_text(),
    ("docs/design.md", "Fronts"): SUSPENDED,
    ("docs/sample.md", "Designs within tolerances"): FRAME.replace("frame", "machine")
    + mounts("machine")
    + '[excitations.push]\ntype = "harmonic"\non = "machine"\nat = [0, 0, 0]\nforce = [0, 0, 100]\n'
    + "[requirements]\ndamping_ratio = 0.01\n",
    ("docs/robust.md", "The best design within tolerances"): (SOURCE / "examples/paper/robust.toml").read_text(),
    ("docs/box.md", "Solution box"): FRAME.replace("frame", "machine")
    + mounts("machine")
    + "[requirements]\ndamping_ratio = 0.01\n",
    ("docs/map.md", "Maps of designs"): (SOURCE / "examples/paper/corrected.toml").read_text(),
    ("docs/plausibility.md", "If the number is right"): STARTER,
    ("docs/map.md", "Several pairs of parameters"): FRAME
    + "".join(
        mount(name, "frame", at) + "damping = {loss_factor = 0.1}\n"
        for name, at in (("left", [0.3, 0.3, 0]), ("right", [0.3, -0.3, 0]), ("rear", [-0.5, 0, 0]))
    )
    + "[requirements]\nnatural_frequencies = {separation = 1.02}\n",
    (KEYS, "Nodes"): FRAME
    + """[elements.tip]
type = "bushing"
on = "frame"
at = [0.4, 0, 0.2]
from = "joint"
translation = ["180 N/mm", "180 N/mm", "420 N/mm"]
""",
    (KEYS, "Element types"): GENSET,
    (KEYS, "Tables of bodies and elements"): GENSET + SHARED_MOUNT,
    (KEYS, "Units of tables and pictures"): FRAME + mounts("frame"),
    (KEYS, "Report"): FRAME + mounts("frame"),
    (KEYS, "Levels"): FRAME.replace("frame", "machine")
    + mounts("machine")
    + '[analyses]\nresponse = {quantity = "velocity", band = ["1 Hz", "100 Hz"]}\n',
    (KEYS, "Excitations"): MACHINE_AND_ENGINE,
    (KEYS, "Flexible foundations"): FRAME
    + mounts("frame", ["hull", "hull", "deck", "measured"])
    + "".join(
        mount(name, "frame", [0, y, 0]) + 'foundation = "slab"\n'
        for name, y in (("left foot", 0.5), ("right foot", -0.5))
    ),
    (KEYS, "Further analyses"): DRIVEN_FRAME,
    ("docs/random.md", "Measured levels as excitation"): FRAME + mounts("frame"),
    ("docs/random.md", "Limit lines in bands"): DRIVEN_FRAME,
    **{(KEYS, heading): FRAME for heading in ON_THE_FRAME},
    (KEYS, "Solids of a body"): "trivet = 1\n" + mounts("frame"),
}
# A part that is not one of a project file is the file of this name, to which the base refers.
NOT_A_PROJECT = {("docs/elements/catalogue.md", "Catalogues of mounts"): "maker.toml"}
# Files that a part names: a text, or a path of a file with the contents.
BELLS = {"catalogue/bells.toml": SOURCE / "examples/pump_set/catalogue/bells.toml"}
CONES = {"catalogue/cones.toml": SOURCE / "examples/genset/catalogue/cones.toml"}
FILES = {
    ("docs/measurements.md", "Measured and computed curves"): {
        "impact_test.uff": SOURCE / "tests/data/measured/seat.uff"
    },
    ("docs/design.md", "Keys, values and margins"): BELLS,
    ("docs/design.md", "Choices of mounts"): CONES,
    ("docs/design.md", "trivet select"): CONES,
    (KEYS, "Flexible foundations"): {
        "y.csv": "frequency_hz,y_z_z,y_z_z_im\n1,1e-5,0\n10,1e-5,0\n100,1e-5,0\n",
        "slab.uff": mobility_of_feet(),
    },
    ("docs/sample.md", "Designs within tolerances"): {
        "batch.csv": "scale\n" + "".join(f"{0.9 + 0.01 * i:.2f}\n" for i in range(20))
    },
    (KEYS, "solid_mount"): {"mount.step": SOURCE / "tests/samples/data/rubber_on_steel.step"},
    (KEYS, "imported"): {"mount.mtx": SOURCE / "tests/data/matrices/beam_coordinate_symmetric.mtx"},
    (KEYS, "measured"): {"rig.csv": SOURCE / "tests/samples/data/rig.csv"},
    (KEYS, "table, air_spring, wire_rope"): {"bellows.csv": SOURCE / "tests/samples/data/air_spring.csv"},
    (KEYS, "Solids of a body"): {"cover.stl": SOURCE / "tests/samples/data/box.stl"},
}
# What the check replaces, so that it takes a second.
COARSER = {(KEYS, "solid_mount"): ('mesh_size = "5 mm"', 'mesh_size = "12 mm"\nrim_size = "6 mm"')}
# Printed output: the command, and the change of the starter file that causes it.
OUTPUTS = {("docs/plausibility.md", "Suspicions"): ("trivet check machine.toml", 'mass = "250 kg"', 'mass = "25 t"')}
