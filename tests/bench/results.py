"""Reads the CSV that palpate-bench writes."""

import csv
import re

MAIN_CUTOFF = "0.02"


class Results:
    def __init__(self, path):
        with open(path, newline="", encoding="utf-8") as file:
            self.rows = list(csv.DictReader(file))

    def find(self, **wanted):
        """Rows whose columns have the wanted values."""
        return [row for row in self.rows if all(row[key] == value for key, value in wanted.items())]

    def scenes(self, bench="pairs"):
        """In the order they were measured in."""
        return list(dict.fromkeys(row["scene"] for row in self.rows if row["bench"] == bench))

    def pair(self, scene, method, quantity, column, cutoff=MAIN_CUTOFF):
        """One number of a pair of models; None if it was not measured."""
        for row in self.find(bench="pairs", scene=scene, method=method, quantity=quantity):
            if parameter(row, "cutoff") == cutoff:
                return float(row[column])
        return None

    def against(self, bench, key, method, quantity, column, **wanted):
        """(parameter, value) in ascending order."""
        rows = self.find(bench=bench, method=method, quantity=quantity, **wanted)
        return sorted((float(parameter(row, key)), float(row[column])) for row in rows)

    def origin(self):
        row = self.rows[0]
        return f"{row['processor']}, {row['compiler']} {row['flags']}, {row['simd']}, commit {row['commit']}"


def parameter(row, key):
    found = re.search(rf"(?:^| ){key}=(\S+)", row["parameters"])
    return found and found.group(1)
