"""What was gained, on readings that were held out, in words."""

import math

from trueaxis.diagnosis.result import Cause, Diagnosis, Gain
from trueaxis.identification.words import enumerated
from trueaxis.reporting.diagnosis.quantity import micrometres, percent, written

MORE = 1.5  # times what is left with new values, from where on it is said what the model as given leaves more
AS_PREDICTED = 0.9, 1.1  # standardised held-out residuals of a model that is right


def held_out_change(cause: Cause) -> str:
    """How a cause changes the held-out RMS, beside new values of all errors."""
    gain = cause.held_out_gain
    if cause.or_changed:
        return "no lower than with new values of the errors"
    return f"{'higher' if gain < 0.0 else 'lower'} by {percent(abs(gain))}" if gain else "unchanged"


def given_note(diagnosis: Diagnosis) -> str:
    """Why readings are far from the model as given; empty where they are not."""
    rms = diagnosis.gain.rms
    if not rms.given > MORE * rms.refitted:
        return ""
    if diagnosis.verdict != "no_discrepancy":
        return (
            "given: every set-up exactly as setup.toml has it; balls and spheres that stand elsewhere, lengths and "
            "scales that are off are in it, too, and are no errors of the machine"
        )
    return (
        "given is larger than refitted by what instruments may be off by (zeros, slopes, places of balls, scales, each "
        "within what its device states or instruments of its class have) and values within their u: no discrepancy"
    )


def predicted_scatter(gain: Gain) -> str:
    """What `standardised` comes to, as a sentence without its end; empty where it is unknown."""
    if not math.isfinite(gain.standardised):
        return ""
    low, high = AS_PREDICTED
    if gain.standardised > high:
        judged = "more than noise and the uncertainty of the values explain"
    elif gain.standardised < low:
        judged = "less than predicted: the assumed noise is too large"
    else:
        judged = "as expected"
    return f"held-out residuals have {written(gain.standardised, '.2f')} times the predicted scatter: {judged}"


def held_out_warning(gain: Gain) -> str:
    """Why held-out readings are predicted worse than by the values given; empty where they are not, or no worse than is
    predicted of them: the values given may rest on more readings than the others.
    """
    if not gain.standardised > AS_PREDICTED[1]:
        return ""
    shown = {name: micrometres(getattr(gain.held_out, name)) for name in ("given", "refitted", "extended")}
    worse = [
        name
        for name in ("refitted", "extended")
        if getattr(gain.held_out, name) > gain.held_out.given and shown[name] != shown["given"]
    ]
    if not worse:
        return ""
    figures = enumerated([f"{name} {shown[name]} um" for name in worse])
    return (
        f"held-out readings are predicted worse ({figures}) than by the given values ({shown['given']} um): they show "
        "something that the other readings do not, such as a change between the runs"
    )
