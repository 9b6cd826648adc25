"""Addition A6: whether a base that is shaken along its own normal parts Fig. 8's mixture at the paper's angles."""
from paper import parting
from paper.parting import ANGLES
from study import THETA, WAYS, Picture, Study, csv_lines, ways
import verdicts

FRAME = "base.drive_frame"
NAMES = {"world": "vertically, as in the paper", "base": "along its own normal"}


def claims(numbers):
    """@param numbers of each axis of the drive: map from θ to both species' mean velocities [m/s]"""
    checks = tuple(parting.parted(f"θ = {theta:g}: A to the right, B to the left", numbers["base"][theta])
                   for theta in ANGLES)
    return [verdicts.Claim("A6", "Fig. 8", "claim 6's A right and B left at 0.105 and at 0.157 come out on a base that "
                           "is shaken along its own normal", checks)]


TEXT = ("A vibrator bolted to the deck shakes it along its normal (`base.drive_frame: base`), which at an inclination "
        "θ also pushes towards the lower end.")


STUDY = Study("deck", "Fig. 8's mixture on a base that is shaken along its own normal",
              ("paper_deck",),
              lambda rows: {frame: ways(group, THETA) for frame, group in rows["paper_deck"].by(FRAME).items()},
              (Picture("deck", "Mean velocities of Fig. 8's mixture over the inclination, d = 3.93, for both axes of "
                       "the drive; bars: standard errors over the seeds", lambda numbers: parting.draw_ways(
                           {f"shaken {name}": numbers[frame] for frame, name in NAMES.items()})),),
              claims, lambda numbers: TEXT, tables=lambda numbers: {
                  "deck": csv_lines(("drive_frame", "theta_rad"), WAYS, {
                      (frame, theta): pair for frame, own in numbers.items() for theta, pair in own.items()})})
