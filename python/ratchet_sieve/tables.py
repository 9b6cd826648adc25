"""Files as a whole, and CSV files: the tables of a run, and the rows of a sweep."""
import contextlib
import csv
import dataclasses
import io
import math
import os
import pathlib
import sys

import pandas

from ratchet_sieve import stats

QUALITIES = QUALITY, STEADY_QUALITY = "quality", "steady.quality.value"  # Q since the start, and of the filled machine


class Refusal(Exception):
    """An error of reading or drawing, in one line."""


@contextlib.contextmanager
def writing(path):
    """Gives the path of a part beside a file, and renames it at the end: the file is written completely or not at all.
    A link stays. A device or a pipe is written itself. An error, such as a full disk, names the file."""
    target = pathlib.Path(os.path.realpath(path))
    is_direct = target.exists() and not target.is_file()
    part = target if is_direct else target.with_name(f"{target.name}.sieve_part{os.getpid()}")
    try:
        yield part
        if not is_direct:
            os.replace(part, target)
    except OSError as error:
        raise OSError(error.errno, error.strerror or str(error), str(path)) from error
    finally:
        if not is_direct and part.exists():
            part.unlink()


def write_text(path, text, **options):
    """As a whole. @param options of open()"""
    with writing(path) as part, open(part, "w", encoding="utf-8", **options) as file:
        file.write(text)


def write_each(name, writers):
    """Calls them all. An error of writing, of standard output as well, is one line, and ends the program only after the
    last: exit status 1."""
    failed = False
    for write in (*writers, sys.stdout.flush):
        try:
            write()
        except OSError as error:
            failed = True
            print(f"{name}: {error.filename or 'standard output'}: {error.strerror}", file=sys.stderr)
            if error.filename is None:  # what is left of it would fail again at the end
                os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    if failed:
        sys.exit(1)


def write_csv(path, columns, lines, end="\n"):
    """@param lines sequences, or maps from column to value; what is missing or None is left empty. @param end of a line
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    table = pandas.DataFrame(list(lines), columns=columns, dtype=object)
    write_text(path, table.to_csv(index=False), newline=end)


def read_csv(path):
    """@return a DataFrame of texts. @throws Refusal a damaged or cut file"""
    try:
        text = pathlib.Path(path).read_bytes().decode("utf-8")
        lines = list(csv.reader(io.StringIO(text, newline=""), strict=True))
    except (UnicodeDecodeError, csv.Error) as error:
        raise Refusal(f"{path}: no table: {error}") from error
    if not text.endswith("\n"):
        raise Refusal(f"{path}: cut off, its last line has no end")
    for count, line in enumerate(lines, 1):
        if len(line) != len(lines[0]):
            raise Refusal(f"{path}: line {count}: {len(line)} fields, must be {len(lines[0])}")
    return pandas.DataFrame(lines[1:], columns=lines[0], dtype=object)


def column_of(frame, name, path):
    """@throws Refusal there is none, or more than one"""
    if list(frame.columns).count(name) != 1:
        raise Refusal(f"{path}: has no column {name}")
    return frame[name]


def typed(text):
    """A field as a number or as text; None where it is not defined."""
    if text == "":
        return None
    try:
        return float(text)
    except ValueError:
        return text


def seed_of(text):
    """Exact: a float holds no seed beyond 2**53."""
    return int(text) if text.isdigit() else typed(text)


class Rows:
    """The lines of a table as a DataFrame: those of a table of a run, of texts; or the runs of a sweep that are done,
    in its order, with numbers and texts. What is not defined is NaN or None there, and left out here."""

    def __init__(self, lines=(), path="", failed=0):
        """@param lines a DataFrame, or maps from column to value. @param failed runs that are not among these"""
        self.frame = lines if isinstance(lines, pandas.DataFrame) else pandas.DataFrame(list(lines))
        self.path, self.failed = path, failed

    def __len__(self):
        return len(self.frame)

    def __getitem__(self, index):
        """One run, as a map from column to value."""
        return {key: None if pandas.isna(value) else value for key, value in self.frame.iloc[index].items()}

    def column(self, name):
        """@throws Refusal there is none; no rows at all have any"""
        return column_of(self.frame, name, self.path) if len(self) else pandas.Series(dtype=object)

    def where(self, conditions):
        """@param conditions map from column to value"""
        chosen = pandas.Series(True, self.frame.index, dtype=bool)
        for key, value in conditions.items() if len(self) else ():
            chosen &= self.column(key).map(lambda other, value=value: same(other, value))
        return Rows(self.frame[chosen], self.path)

    def values(self, key):
        """The different values of a column, in order: numbers, then texts."""
        return sorted(self.column(key).dropna().unique(), key=lambda value: (isinstance(value, str), value))

    def by(self, *keys):
        """@return map from the values of these keys, or the value of one, to their rows; in the order of the lines"""
        if not len(self):
            return {}
        columns = [self.column(key) for key in keys]
        groups = self.frame.groupby(columns if len(keys) > 1 else columns[0], sort=False)
        return {place: Rows(group, self.path) for place, group in groups}

    def numbers(self, name, scale=1.0):
        """A column of texts as an array. An empty field is undefined: NaN, which interrupts a drawn line."""
        texts = column_of(self.frame, name, self.path)
        values = pandas.to_numeric(texts.where(texts != "", "nan"), errors="coerce").astype(float)
        wrong = texts[values.isna() & ~texts.str.lower().isin(("", "nan"))]
        if len(wrong):
            raise Refusal(f"{self.path}: {name}: {wrong.iloc[0]}: must be a number")
        return scale * values.to_numpy()

    def samples(self, field):
        """The defined values of a column, or of a function of the DataFrame: one for each run."""
        if not callable(field) and field not in self.frame:
            return []
        values = (field(self.frame) if callable(field) else self.column(field)).dropna()
        for text in values[values.map(lambda value: isinstance(value, str))]:
            raise Refusal(f"{self.path}: {field}: {text}: must be a number")
        return values.tolist()

    def mean(self, field):
        """The mean over the runs, which are independent: their seeds differ. None where no run defines the field.
        Of QUALITIES it is |mean separation|, with the error of that mean: the mean of Q
        itself is never 0."""
        signed = field.replace("quality", "separation") if field in QUALITIES else None
        if signed in self.frame:
            mean = self.mean(signed)
            return mean and dataclasses.replace(mean, value=abs(mean.value))
        return stats.mean_of(self.samples(field))


def read_table(path):
    """A table of a run, whose columns are named without their units. @return Rows of texts"""
    frame = read_csv(path)
    return Rows(frame.rename(columns=lambda column: column.split(" [")[0]), path)


def same(a, b):
    if isinstance(a, float) and isinstance(b, (int, float)):
        return math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-12)
    return a == b


def joined(*parts):
    """Rows of several sweeps, one after the other."""
    return Rows(pandas.concat([part.frame for part in parts], ignore_index=True))


def read_rows(path, texts=None):
    """The results of a sweep as sieve_sweep exports them. @param texts what read_csv() gave of the path, if it did"""
    texts = read_csv(path) if texts is None else texts
    done = column_of(texts, "status", path) == "done"
    frame = pandas.DataFrame({name: column_of(texts, name, path)[done] for name in texts})
    for name in frame:
        if not name.endswith("_hash"):
            frame[name] = frame[name].map(seed_of if name == "seed" else typed)
    return Rows(frame.reset_index(drop=True), path, int((~done).sum()))


def rows_of(frame):
    """The cases that are done of a DataFrame of ratchet_sieve.sweep() or read_sweep(), with their throughput."""
    done = frame[frame["status"] == "done"]
    return Rows(done.assign(throughput=throughput(done)), "sweep", len(frame) - len(done))


def departed(frame):
    """Disks of all species that left, of each run. @param frame of Rows"""
    return frame[[name for name in frame if name.startswith(("left.", "right."))]].sum(axis=1, min_count=1)


def species_of(frame):
    """The names of the species, in the scene's order. @param frame of Rows"""
    return [name[len("left."):] for name in frame if name.startswith("left.")]


def throughput(frame):
    """Disks that left in a second, of each run [1/s]. @param frame of Rows"""
    return departed(frame) / frame["simulated_time"].where(frame["simulated_time"] > 0.0)
