"""The library of kinds: what is known to go wrong between a machine, its instruments and its model.

Every term is written once, in the context variables of `variables`; what it does to each instrument follows from the
derivation (sensitivity of the reading times the term).
"""

from trueaxis.effects.kind import Kind, Parameter

ALL_DIRECTIONS = ("along", "across", "turn")

KINDS: tuple[Kind, ...] = (
    Kind(
        name="backlash",
        place="component",
        expression="width/2*direction",
        parameters=(
            Parameter(name="width", unit="u", meaning="lost motion: jump between the two directions of approach"),
        ),
        sentence="play or elastic wind-up in the drive (along the axis: lost motion) "
        "or in the guides (across: lateral play)",
        confused_with="servo lag on circles of one feed",
        broken_by="circles in both directions, or lines in both",
        directions=ALL_DIRECTIONS,
    ),
    Kind(
        name="backlash_slope",
        place="component",
        expression="change*direction*(s - 1/2)",
        parameters=(
            Parameter(
                name="change",
                unit="u",
                meaning="change of half the lost motion from one end of the travel to the other",
            ),
        ),
        sentence="lost motion that varies along the travel: a worn part of the screw, "
        "wind-up that depends on its free length",
        directions=ALL_DIRECTIONS,
    ),
    Kind(
        name="cyclic",
        place="component",
        expression="amplitude*cos(2*pi*q/pitch + phase)",
        parameters=(
            Parameter(name="amplitude", unit="u", meaning="amplitude"),
            Parameter(name="phase", unit="rad", meaning="phase at position 0", role="phase"),
            Parameter(name="pitch", unit="axis", meaning="period", role="grid", grid="pitch"),
        ),
        sentence="a periodic error: pitch of the screw, its coupling, an eccentric encoder, interpolation of a scale",
        confused_with="any other part that turns once per pitch; its aliases, where targets are equidistant",
        broken_by="targets at irregular distances",
        directions=("along", "across"),
    ),
    Kind(
        name="thermal_expansion",
        place="component",
        expression="coefficient*q*T",
        parameters=(Parameter(name="coefficient", unit="u/axis/K", meaning="expansion per kelvin"),),
        sentence="a scale or screw that grows with its temperature",
        confused_with="warm_up; scale of the axis, unless the temperature varies",
        broken_by="a change of temperature within a line; lines repeated at other temperatures",
        directions=("along",),
    ),
    Kind(
        name="thermal_offset",
        place="component",
        expression="coefficient*T",
        parameters=(Parameter(name="coefficient", unit="u/K", meaning="displacement or rotation per kelvin"),),
        sentence="a structure that bends or shifts with its temperature",
        confused_with="drift",
        broken_by="a temperature that does not follow the time",
        directions=ALL_DIRECTIONS,
    ),
    Kind(
        name="warm_up",
        place="component",
        expression="amplitude*s*exp(-t/tau)",
        parameters=(
            Parameter(
                name="amplitude", unit="u", meaning="growth still to come at time 0, at the upper end of the travel"
            ),
            Parameter(name="tau", unit="s", meaning="time constant", role="grid", grid="time"),
        ),
        sentence="a screw or scale that warms up by its own friction",
        confused_with="thermal_expansion; laser_cosine, where one line is measured once",
        broken_by="the line repeated later",
        directions=("along",),
    ),
    Kind(
        name="drift",
        place="component",
        expression="rate*t",
        parameters=(Parameter(name="rate", unit="u/s", meaning="change per second"),),
        sentence="something drifts during the measurement: temperature, foundation, fixture",
        confused_with="thermal_offset, where the temperature follows the time",
        broken_by="a temperature channel",
        directions=ALL_DIRECTIONS,
    ),
    Kind(
        name="servo_lag",
        place="component",
        expression="-tau*v",
        parameters=(
            Parameter(
                name="tau",
                unit="s",
                meaning="time by which the axis lags its command, beyond that of the other axes",
            ),
        ),
        sentence="following error of the position loop; only its difference between axes shows in a circle",
        confused_with="backlash, on circles of one feed; servo lag of the other axis, with the other sign",
        broken_by="circles at two feeds",
        directions=("along",),
    ),
    Kind(
        name="reversal_spike",
        place="component",
        expression="height*direction*exp(-d/decay)",
        parameters=(
            Parameter(name="height", unit="u", meaning="height right after the reversal"),
            Parameter(name="decay", unit="axis", meaning="distance over which it decays", role="grid", grid="reversal"),
        ),
        sentence="friction that the position loop has to overcome at a reversal (quadrant glitch)",
        confused_with="backlash; reversal_spike_time and reversal_spike_path, on circles of one radius and feed",
        broken_by="samples close to the reversals; circles of two radii",
        directions=("along",),
    ),
    Kind(
        name="reversal_spike_time",
        place="component",
        expression="height*direction*exp(-d_time/tau)",
        parameters=(
            Parameter(name="height", unit="u", meaning="height right after the reversal"),
            Parameter(name="tau", unit="s", meaning="time over which it decays", role="grid", grid="reversal_time"),
        ),
        sentence="friction at a reversal that the integral part of the control loop overcomes: as long at any feed",
        confused_with="backlash; reversal_spike and reversal_spike_path, on circles of one radius and feed",
        broken_by="samples close to the reversals; circles at two feeds",
        directions=("along",),
    ),
    Kind(
        name="reversal_spike_path",
        place="component",
        expression="height*direction*exp(-d_path/decay)",
        parameters=(
            Parameter(name="height", unit="u", meaning="height right after the reversal"),
            Parameter(
                name="decay",
                unit="mm",
                meaning="distance along the path over which it decays",
                role="grid",
                grid="reversal_path",
            ),
        ),
        sentence="friction at a reversal that is overcome as the path goes on, whichever axis moves",
        confused_with="backlash; reversal_spike and reversal_spike_time, on circles of one radius and feed",
        broken_by="samples close to the reversals; circles of two radii and at two feeds",
        directions=("along",),
    ),
    Kind(
        name="cross_axis",
        place="component",
        expression="k*s*s_b^2",
        parameters=(Parameter(name="k", unit="u", meaning="value at the far ends of both travels"),),
        sentence="a body that bends under another one: the component error of one axis "
        "depends on where another axis stands",
        confused_with="the same effect of another component, where the sensitivity to both is alike",
        broken_by="lines at three offsets or more",
        directions=ALL_DIRECTIONS,
        other_axis=True,
    ),
    Kind(
        name="laser_cosine",
        place="reading",
        expression="-angle^2/2*along",
        parameters=(Parameter(name="angle", unit="rad", meaning="angle between beam and motion", role="root"),),
        sentence="the laser beam was not parallel to the motion: it reads short",
        confused_with="scale of the axis, where all its lines are off alike",
        broken_by="four lines or more of the axis; a straightness run along the line",
        instruments=("laser",),
        by_run=True,
    ),
    Kind(
        name="laser_scale",
        place="reading",
        expression="k*along",
        parameters=(Parameter(name="k", unit="1", meaning="relative error of all laser distances"),),
        sentence="wavelength of the laser: air temperature, pressure or humidity were not what was entered",
        confused_with="length of the ball bar; scale of all axes",
        broken_by="a calibrated step gauge, or a calibrated bar",
        instruments=("laser",),
    ),
    Kind(
        name="laser_step",
        place="reading",
        expression="jump*step(t - t_0)",
        parameters=(
            Parameter(name="jump", unit="mm", meaning="height of the jump"),
            Parameter(name="t_0", unit="s", meaning="moment of the jump", role="grid", grid="moment"),
        ),
        sentence="something slipped or lost counts in the middle of a run",
        confused_with="outliers near the end of a run",
        broken_by="the run repeated",
        instruments=("laser",),
        by_run=True,
    ),
    Kind(
        name="reading_zero",
        place="reading",
        expression="zero",
        parameters=(Parameter(name="zero", unit="mm", meaning="value added to all readings of the runs"),),
        sentence="the readings were zeroed elsewhere than the set-up says, or the instrument was touched between runs",
        confused_with="what the machine does between home and the first target",
        broken_by="the run repeated with a new zero",
        by_run=True,
        nuisance=True,
    ),
    Kind(
        name="reading_slope",
        place="reading",
        expression="slope*along_line",
        parameters=(
            Parameter(
                name="slope", unit="1", meaning="change of the reading per displacement along the line of the motion, mm/mm"
            ),
        ),
        sentence="the reference line of a straightness run (its optics, a straightedge) is not parallel to the motion",
        confused_with="squareness; laser_cosine, laser_scale",
        broken_by="the run repeated with the reference line turned over or aligned anew",
        instruments=("laser", "probe"),
        by_run=True,
        nuisance=True,
    ),
    Kind(
        name="point_offset",
        place="point",
        expression="",
        parameters=(
            Parameter(name="x", unit="mm", meaning="offset of the point along X of its body's frame"),
            Parameter(name="y", unit="mm", meaning="the same along Y"),
            Parameter(name="z", unit="mm", meaning="the same along Z"),
        ),
        sentence="target or reference point is not where the set-up says (Abbe offset)",
        confused_with="positioning error",
        broken_by="the same line at two known offsets",
        instruments=("laser",),
        by_run=True,
    ),
    Kind(
        name="ballbar_length",
        place="reading",
        expression="length",
        parameters=(Parameter(name="length", unit="mm", meaning="actual minus nominal length of the bar"),),
        sentence="the bar is longer than stated (shorter, where the length is negative)",
        confused_with="laser_scale; scale of all axes",
        broken_by="the bar calibrated",
        instruments=("ballbar",),
    ),
    Kind(
        name="ballbar_centre",
        place="point",
        expression="",
        parameters=(
            Parameter(name="x", unit="mm", meaning="offset of the ball along X of its body's frame"),
            Parameter(name="y", unit="mm", meaning="the same along Y"),
            Parameter(name="z", unit="mm", meaning="the same along Z"),
        ),
        sentence="the workpiece ball is not where the set-up says",
        confused_with="first harmonic of a straightness",
        instruments=("ballbar",),
        by_run=True,
    ),
    Kind(
        name="ballbar_lobes",
        place="reading",
        expression="amplitude*cos(3*theta + phase)",
        parameters=(
            Parameter(name="amplitude", unit="mm", meaning="amplitude"),
            Parameter(name="phase", unit="rad", meaning="phase at polar angle 0", role="phase"),
        ),
        sentence="form error of the balls or of the bar's sockets: three lobes",
        confused_with="non-rigid coupling of two axes; bow of a guide",
        broken_by="the bar turned in its sockets",
        instruments=("ballbar",),
    ),
    Kind(
        name="squareness",
        place="location",
        expression="",
        parameters=(Parameter(name="angle", unit="rad", meaning="location error of the axis"),),
        sentence="a location error of the axis that the spec leaves out",
        confused_with="slope of the straightness (a matter of convention)",
        directions=("turn",),
    ),
)

BY_NAME = {kind.name: kind for kind in KINDS}
