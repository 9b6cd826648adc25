"""The results of a sweep as sieve_sweep exports them: one row for each run."""
import csv
import math

from reproduce.samples import mean_of


def read_value(text):
    """A field as a number or as text; None where it is not defined."""
    if text == "":
        return None
    try:
        return float(text)
    except ValueError:
        return text


def same(a, b):
    if isinstance(a, float) and isinstance(b, (int, float)):
        return math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-12)
    return a == b


class Rows(list):
    """The runs that are done, each a map from column to value, in the order of the sweep."""

    failed = 0  # runs that failed, and are not among these

    def where(self, conditions):
        """@param conditions map from column to value"""
        return Rows(row for row in self if all(same(row.get(key), value) for key, value in conditions.items()))

    def values(self, key):
        """The different values of a column, in order."""
        return sorted({row[key] for row in self if row.get(key) is not None})

    def by(self, *keys):
        """@return map from the values of these keys to their rows; of one key, from its value"""
        groups = {}
        for row in self:
            place = tuple(row[key] for key in keys)
            groups.setdefault(place if len(keys) > 1 else place[0], Rows()).append(row)
        return groups

    def samples(self, field):
        """The defined values of a column, or of a function of a row: one for each run."""
        take = field if callable(field) else lambda row: row.get(field)
        return [value for value in map(take, self) if value is not None]

    def mean(self, field):
        """The mean over the runs, which are independent: their seeds differ. None where no run defines the field."""
        return mean_of(self.samples(field))


def read_rows(path):
    with open(path, newline="", encoding="utf-8") as file:
        lines = csv.DictReader(file)
        rows, failed = Rows(), 0
        for line in lines:
            if line["status"] != "done":
                failed += 1
                continue
            rows.append({key: text if key.endswith("_hash") else read_value(text) for key, text in line.items()})
    rows.failed = failed
    return rows
