"""Reading and writing of tables."""
import os
import pathlib
import subprocess
import tempfile
import unittest

from ratchet_sieve.tables import Refusal, Rows, joined, read_rows, read_table, throughput, write_csv, write_text, writing

CASES = """base.frequency,boundary,seed,status,simulated_time,left.A,right.A,left.B,right.B,quality,scene_hash
20,open,1,done,10,1,2,3,4,0.5,1e5
20,open,2,done,10,1,2,3,4,,1e6
30,walled,1,failed,,,,,,,ab
30,walled,2,done,0,,,,,,1e7
"""


class Tables(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.path = pathlib.Path(scratch.name) / "made" / "table.csv"
        self.path.parent.mkdir()

    def read(self, text, reader):
        self.path.write_text(text, encoding="utf-8")
        return reader(self.path)

    def test_a_pipe_is_written_itself_and_a_part_is_renamed(self):
        pipe = self.path.with_name("pipe")
        os.mkfifo(pipe)
        reader = subprocess.Popen(["cat", pipe], stdout=subprocess.PIPE, text=True)
        write_text(pipe, "all")
        self.assertEqual(reader.communicate()[0], "all")
        with self.assertRaises(ValueError), writing(self.path) as part:
            part.write_text("half", encoding="utf-8")
            raise ValueError
        self.assertEqual([file.name for file in self.path.parent.iterdir()], ["pipe"])

    def test_columns_are_named_without_their_units(self):
        table = self.read("time [s],species\n0,1e5\n2.5,B\n,B\n", read_table)
        self.assertEqual(list(table.by("species")), ["1e5", "B"])
        self.assertEqual(list(table.numbers("time", 2.0)[:2]), [0.0, 5.0])
        self.assertEqual(str(table.where({"species": "B"}).numbers("time")), "[2.5 nan]")

    def test_what_is_no_table_of_numbers_is_refused(self):
        for text, column, because in (("time\n1e\n", "time", "time: 1e: must be a number"),
                                      ("time\n1\n", "mass", "has no column mass"),
                                      ("time\n1,2\n", "time", "line 2: 2 fields, must be 1"),
                                      ("time\n1", "time", "cut off, its last line has no end")):
            with self.assertRaisesRegex(Refusal, f"^{self.path}: {because}$"):
                self.read(text, read_table).numbers(column)

    def test_rows_are_the_runs_that_are_done(self):
        rows = self.read(CASES, read_rows)
        self.assertEqual((len(rows), rows.failed), (3, 1))
        self.assertEqual((rows[0]["boundary"], rows[0]["scene_hash"], rows[1]["quality"]), ("open", "1e5", None))
        self.assertEqual((rows.values("base.frequency"), rows.values("boundary")), ([20.0, 30.0], ["open", "walled"]))
        self.assertEqual(rows.samples("quality"), [0.5])
        self.assertIsNone(rows.where({"boundary": "walled"}).mean("quality"))
        self.assertEqual({place: len(own) for place, own in rows.by("base.frequency", "boundary").items()},
                         {(20.0, "open"): 2, (30.0, "walled"): 1})
        self.assertEqual(len(joined(rows, Rows(), rows)), 6)
        with self.assertRaisesRegex(Refusal, f"^{self.path}: boundary: open: must be a number$"):
            rows.mean("boundary")

    def test_a_seed_is_exact(self):
        text = "seed,status\n1,done\n9007199254740993,done\n18446744073709551615,done\n"
        rows = self.read(text, read_rows)
        self.assertEqual(rows.values("seed"), [1, 2 ** 53 + 1, 2 ** 64 - 1])
        self.assertEqual(len(rows.where({"seed": 2 ** 53 + 1})), 1)

    def test_the_mean_quality_is_that_of_the_mean_separation(self):
        text = "seed,status,error,quality,separation,simulated_time\n1,done,,0.1,0.1,1\n2,done,,0.3,-0.3,1\n"
        mean = self.read(text, read_rows).mean("quality")
        self.assertAlmostEqual(mean.value, 0.1)
        self.assertAlmostEqual(mean.error, 0.2)

    def test_no_rows_have_no_values(self):
        none = Rows()
        self.assertEqual((none.values("seed"), none.by("seed"), len(none.where({"seed": 1})), none.mean("quality")),
                         ([], {}, 0, None))

    def test_throughput_is_over_time_and_of_all_species(self):
        rows = self.read(CASES, read_rows)
        self.assertEqual(rows.samples(throughput), [1.0, 1.0])  # undefined where no time was simulated

    def test_what_is_written_is_read_again(self):
        path = self.path.parent / "new" / "rows.csv"
        write_csv(path, ["a", "b"], [{"a": 1, "b": "x, y"}, {"b": None}])
        self.assertEqual(path.read_text(encoding="utf-8"), 'a,b\n1,"x, y"\n,\n')
        write_csv(path, ["a", "b"], ([0.1, 2],))
        self.assertEqual(path.read_text(encoding="utf-8"), "a,b\n0.1,2\n")
