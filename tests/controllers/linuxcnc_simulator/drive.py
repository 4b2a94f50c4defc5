#!/usr/bin/python3
"""In place of a display: drives LinuxCNC through the commands of commands.json, notes in done.json where axes and
joints stand after each, and what the pins of the module say. Run by LinuxCNC with the Python that has its modules.
"""

import json
import signal
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

import hal
import linuxcnc

PINS = ("share", "fault", "converged", "steps", "correction-x", "correction-y", "correction-z")


def wait(true: Callable[[], bool], seconds: float, what: str) -> None:
    end = time.time() + seconds
    while not true():
        if time.time() > end:
            raise SystemExit(f"waited in vain for {what}")
        time.sleep(0.002)


def at_rest(status: linuxcnc.stat) -> bool:
    return bool(status.inpos and status.interp_state == linuxcnc.INTERP_IDLE and status.queue == 0)


def stood(status: linuxcnc.stat, seconds: float) -> list[tuple[list[float], list[float]]]:
    """Position and joints wherever they stay the same for 20 ms: in a dwell."""
    found, before, end = [], None, time.time() + seconds
    while time.time() < end:
        status.poll()
        now = (list(status.position), list(status.joint_position))
        if now == before:
            found.append(now)
        before = now
        time.sleep(0.02)
    return found


def main() -> None:
    asked = json.loads(Path("commands.json").read_text())
    count, pins = asked["joints"], PINS if asked["module"] else ()
    status, command, errors = linuxcnc.stat(), linuxcnc.command(), linuxcnc.error_channel()
    component = hal.component("drive")
    component.ready()

    with Path("samples.txt").open("w") as samples:
        sampler = subprocess.Popen(["halsampler"], stdout=samples)

    def polled(true: Callable[[], bool]) -> Callable[[], bool]:
        def now() -> bool:
            status.poll()
            return true()

        return now

    for state in (linuxcnc.STATE_ESTOP_RESET, linuxcnc.STATE_ON):
        command.state(state)
        command.wait_complete()
    wait(polled(lambda: status.task_state == linuxcnc.STATE_ON), 10, "the machine to be on")
    command.mode(linuxcnc.MODE_MANUAL)
    command.wait_complete()
    command.home(-1)
    wait(polled(lambda: all(status.homed[:count])), 30, "homing")
    command.mode(linuxcnc.MODE_MDI)
    command.wait_complete()
    done = []
    for word in asked["commands"]:
        stands: list[tuple[list[float], list[float]]] = []
        if word.startswith(("setp ", "unlinkp ")):
            subprocess.run(["halcmd", *word.split()], check=True)
        else:
            command.mdi(word)
            stands = stood(status, 2.0) if word.startswith("G82") else []
            command.wait_complete(60)
        wait(polled(lambda: at_rest(status)), 60, word)
        time.sleep(0.02)  # a tool's length reaches the pin with the next cycle
        if asked["module"]:
            wait(lambda: hal.get_value("trueaxiskins.settled"), 10, f"the ramp after {word}")
        else:
            time.sleep(0.3)  # corrections of a table come with a ramp that no pin tells of
        time.sleep(0.02)
        status.poll()
        done.append(
            {
                "command": word,
                "position": status.position,
                "joints": status.joint_position[:count],
                "deepest": min(stands, key=lambda one: one[0][2], default=None),
                "tool": status.tool_offset[:3],
                "pins": {name: hal.get_value(f"trueaxiskins.{name}") for name in pins},
                "on": status.task_state == linuxcnc.STATE_ON,
            }
        )
    sampler.send_signal(signal.SIGINT)
    sampler.wait(10)
    told = []
    while (error := errors.poll()) is not None:
        told.append(error[1])
    Path("done.json").write_text(json.dumps({"done": done, "errors": told, "offset": status.g5x_offset[:3]}))


main()
