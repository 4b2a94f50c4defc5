"""The table Notation of equations.md: signs that are neither errors nor dimensions of the machine."""

from collections.abc import Iterator

from trueaxis.derivation.model import DerivedModel
from trueaxis.machine.machine import Machine

Entry = tuple[str, str]  # sign, meaning

_PAPER: tuple[Entry, ...] = (
    ("$h$", "number of a given position; $h = 0$ at home"),
    ("$x_h$, $y_h$, $z_h$", "positions of X, Y, Z there, mm"),
    (
        "$P_{lh}$, $P_{kh}$",
        "points of worktable and tool in the bed frame, $(x_{lh}, y_{lh}, z_{lh}, 1)^T$ and $k$ alike",
    ),
    (
        "$r_l$, $r_k$",
        "the same points in the frames of the Y and the Z carriage, mm; coordinates $r_{lx}$, $r_{ky}$, ...",
    ),
    ("$r_W$, $r_T$", "the same points in the workpiece frame (WCS) and the tool frame (TCS), mm; $r_T$ is $P_T$"),
    ("$r_{k1}$, $r_{l4}$, ...", "points of the runs, with their numbers; point $i$ is any of them"),
    (
        "$S^l_{lh}$, $S^l_{jh}$, $S^l_{kh}$",
        "ideal motion of the Y, X and Z carriage: the translation in their $[SIJ]_s$",
    ),
    ("$L_{1xh}$", "displacement read at point 1 along x, from home to position $h$, mm"),
    ("$\\delta_{ih}$, $\\theta$", "straightness of a linkage line, mm, and its angle in its plane, rad"),
    ("$b_k$", "right-hand side of row $k$ of a system"),
    ("$u$, $v$", "two of the directions x, y, z: $v$ along an axis, $u$ across it"),
    ("$v_i$, $n$", "the $i$-th of the $n$ given positions of axis $v$, mm; $v_0 = 0$ is home"),
    ("$P_{uv}$, $P_{uvi}$", "offset in direction $u$ of the line of axis $v$, at position $h$ and at $v_i$, mm"),
    ("$`P'_{uv}`$, $c_{uv0}$, $c_{uv1}$", "straight line fitted to $P_{uv}$, its offset (mm) and slope"),
)
_SYSTEMS: tuple[Entry, ...] = (
    ("$L_k$, $b_k$", "reading $k$ of a system, less that of the error-free machine, and its right-hand side, mm"),
    ("$r_{T1}$, $r_{W1}$, ...", "points of the runs on the tool and on the workpiece, in their frames, mm"),
)
_MOTIONS: tuple[Entry, ...] = (
    ("$r_W$, $r_T$", "points in the workpiece frame and in the tool frame, mm"),
    (r"$\Delta x$, $\Delta y$, $\Delta z$", "displacement since home; under Compensation moves of the linear axes, mm"),
)


def notation(model: DerivedModel, *, paper: bool) -> Iterator[Entry]:
    """The entries of a page."""
    machine = model.machine
    yield "$I$, $J$", "a body and the body that stands on it: $[SIJ]$ takes coordinates in $J$ to coordinates in $I$"
    yield "$[SBW]$, $[SBT]$, $[SBk]$", _ends(machine)
    yield "$M$", "error-free transform from the tool frame to the workpiece frame"
    yield (
        r"$\Theta_k$, $D_k$",
        "small rotation (rad) and displacement (mm) of body $k$ in the bed frame, by all errors below it",
    )
    yield (
        "motion errors, location errors",
        "the error motions of an axis and the constant errors of its place (ISO 230-1)",
    )
    yield "view", "a point of one body in the frame of another: `tool_in_bed` is a point of the tool in the bed frame"
    yield "$P_T$, $P_T^W$", _tool_point(paper)
    yield "$P$", "error-free tool point in the bed frame"
    yield (
        "$d$",
        "deviation of the tool point in the workpiece frame, mm; under Compensation the displacement that is wanted",
    )
    yield (
        "$P_W$, $P_E$, $l_1$",
        "workpiece ball of a ball bar, vector from it to the tool ball, ideal length of the bar, mm",
    )
    yield "$E$, $E_v$", "positioning error along the bar and its vector, mm"
    if paper:
        yield from _PAPER
        yield r"$\Delta P$", "displacement since home (11)"
        yield r"$\Delta x$, $\Delta y$, $\Delta z$", "moves of the linear axes, mm"
        return
    yield from _MOTIONS
    if model.identification and model.identification.systems:
        yield from _SYSTEMS


def _ends(machine: Machine) -> str:
    return (
        f"$B$ is the bed (body 1), $W$ the workpiece (body {machine.workpiece}), $T$ the tool (body {machine.tool}), "
        "$k$ any body"
    )


def _tool_point(paper: bool) -> str:
    own = ", in the paper $(X_T, Y_T, Z_T, 1)^T$" if paper else ""
    return f"a point in the tool frame, $(r_x, r_y, r_z, 1)^T${own}, and the same point in the workpiece frame"
