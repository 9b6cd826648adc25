import dataclasses
import json
import pathlib
import tempfile
import unittest

from ratchet_sieve.stats import Mean
from ratchet_sieve.tables import read_rows
import document
import paper
import sweeps
import validation
from study import Outcome, Picture, Study
from verdicts import Claim, above

CSV = """base.frequency,seed,status,error,simulated_time,wall_time,mean_vx.A,quality,version,physics,scene_hash
20,1,done,,10,50,0.5,,0.1.0,1,1e5
20,2,done,,10,70,0.7,,0.1.0,1,1e6
20,3,failed,no memory,,,,,0.1.0,1,ab
"""


def hand_made_rows():
    with tempfile.TemporaryDirectory() as directory:
        path = pathlib.Path(directory) / "rows.csv"
        path.write_text(CSV, encoding="utf-8")
        return read_rows(path)


def hand_made_study():
    return Study("made", "Made by hand", ("paper_fig5",), lambda rows: rows["paper_fig5"].mean("mean_vx.A"),
                 (Picture("made", "A caption", None),),
                 lambda mean: [Claim("1", "Fig. 0", "it goes right", (above("⟨V_x⟩ > 0", mean),))],
                 figures=lambda mean: {"made.drift": mean.text()}, tables=lambda mean: {"made": (["f"], [["20"]])})


class Documents(unittest.TestCase):
    def test_rows_are_read_and_the_failed_are_counted(self):
        rows = hand_made_rows()
        self.assertEqual((len(rows), rows.failed), (2, 1))
        self.assertIsNone(rows[0]["quality"])
        self.assertEqual(rows[0]["scene_hash"], "1e5")
        self.assertEqual(rows.where({"base.frequency": 20}).samples("mean_vx.A"), [0.5, 0.7])

    def test_a_document_says_what_came_out(self):
        study, rows = hand_made_study(), {"paper_fig5": hand_made_rows()}
        with tempfile.TemporaryDirectory() as directory:
            template, path = pathlib.Path(directory) / "template.md", pathlib.Path(directory) / "paper.md"
            template.write_text("# Title\n\n$about\n\n$claims\n\n$study_made\n\n$machines\n", encoding="utf-8")
            template.with_name("checks.md").write_text("# Checks\n\n$checks\n", encoding="utf-8")
            outcome = Outcome(study, study.evaluate(rows), rows)
            other = dataclasses.replace(outcome, study=dataclasses.replace(study, name="other", claims=lambda _: []))
            document.write(path, template, [outcome, other], "scripts/reproduce")
            text = path.read_text(encoding="utf-8")
            others = path.with_name("paper_checks.md").read_text(encoding="utf-8")
            figures = json.loads((path.parent / "data/paper.json").read_text(encoding="utf-8"))
            table = (path.parent / "data/paper_made.csv").read_text(encoding="utf-8")
        self.assertIn("| 1 | Fig. 0 | it goes right | **undecided** |", text)
        self.assertIn("- Claim 1 **undecided**: ⟨V_x⟩ > 0: 0.60 ± 0.10 (n = 2)\n", text)
        self.assertIn("![A caption](images/paper_made.png)", text)
        self.assertIn("*A caption; n = 2 runs a point.*", text)
        self.assertEqual((figures["made.drift"], figures["claim.1.verdict"]), ("0.60 ± 0.10", "undecided"))
        self.assertEqual(table, "f\n20\n")
        self.assertIn("2 runs of 10 s, seeds 1 to 2, **1 failed** and left out.", text.replace("\n", " "))
        self.assertIn("# Checks\n\n## Made by hand\n\nPicture: [made](images/paper_made.png). Numbers:", others)
        self.assertIn("| fig5 | 20 | 0.1 to 0.9 | 20 | 6 | 1 | — | 0.6 | 0.1 | 0.4 | 0.05 | 2 | 12 to 50 | 12 | 6 |",
                      text)
        self.assertIn("ratchet_sieve 0.1.0, physics version 1 (", text)

    def test_the_words_of_a_verdict_are_bold(self):
        checks = (above("⟨V_x⟩ holds", Mean(1.0, 0.1, 4)), above("", None).about("40 teeth"))
        self.assertEqual(document.verdict(Claim("1", "", "", checks, "at 5 Hz")),
                         "**holds**: ⟨V_x⟩ holds; **undecided**: 40 teeth at 5 Hz")
        self.assertTrue(document.checks([Claim("1", "", "", checks)]).startswith("- Claim 1:\n"))

    def test_claims_stand_in_the_order_of_their_numbers(self):
        study = dataclasses.replace(hand_made_study(), claims=lambda _: [
            Claim(number, "", "", ()) for number in ("10", "A2", "7", "6", "A1")])
        lines = document.claims_table(document.claims_of([Outcome(study, None, {})])).splitlines()[2:]
        self.assertEqual([line.split(" | ")[0] for line in lines], ["| 6", "| 7", "| 10", "| A1", "| A2"])

    def test_the_sweeps_of_these_documents_are_those_of_their_studies(self):
        used = {name for package in (paper, validation) for study in package.STUDIES for name in study.sweeps}
        there = {path.stem for path in sweeps.DIRECTORY.glob("*.yaml")
                 if path.stem.startswith(("paper_", "parting_", "validation_"))}
        self.assertEqual(there, used)
