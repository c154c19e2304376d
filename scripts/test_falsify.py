#!/usr/bin/env python3
"""What falsify.py --check refuses: claims that no change of the library or the laboratory falsifies."""

import unittest

import falsify

FOREIGN = "lab/tests/papers/jia.rs::eq_14_the_product_in_whole_numbers"
NONSENSE = f"| §4, moon | the moon is made of cheese | `{FOREIGN}` | holds |"


def refused(text=None, change=None):
    mutations, without = falsify.table()
    if change:
        mutations.append({"file": "src/scalar/quat.rs", "old": "angle * R::HALF", "new": "angle", "tests": [FOREIGN]} | change)
    return falsify.check(mutations, without, list(falsify.claims(text)), *falsify.readers())


def with_row(row):
    """The claims with one row more in the table of Jia."""
    text = (falsify.ROOT / "docs/claims.md").read_text()
    place = "| §4, inverse |"
    assert text.count(place) == 1
    return text.replace(place, f"{row}\n{place}")


class Check(unittest.TestCase):
    def test_what_is_there_passes(self):
        self.assertEqual(refused(), [])

    def test_a_claim_with_a_foreign_test_is_refused(self):
        self.assertEqual(refused(with_row(NONSENSE)), ["no change falsifies: Jia §4, moon"])

    def test_the_tests_of_a_claim_are_there(self):
        gone = "| §4, moon | it is round | `tests/laws.rs::the_moon_is_round` | holds |\n"
        found = refused(with_row(gone))
        self.assertTrue(any(line.endswith("no such test: tests/laws.rs::the_moon_is_round") for line in found), found)

    def test_a_claim_cannot_hide_behind_the_name_of_another(self):
        found = refused(with_row(NONSENSE.replace("§4, moon", "§4, inverse")))
        self.assertTrue(any("two rows are called Jia §4, inverse" in line for line in found), found)

    def test_a_change_of_a_test_falsifies_no_claim(self):
        change = {"file": "lab/tests/papers/jia.rs", "old": "quat(-9.0, -6.0, 3.0, 18.0)", "rows": ["Jia §4, moon"]}
        found = refused(with_row(NONSENSE), change)
        self.assertTrue(any("a change of a test falsifies no row" in line for line in found), found)
        self.assertIn("no change falsifies: Jia §4, moon", found)

    def test_a_change_falsifies_only_by_a_test_of_the_row(self):
        change = {"rows": ["Jia §9, eq. 45"]}
        self.assertIn("src/scalar/quat.rs: none of its tests is one of Jia §9, eq. 45", refused(change=change))

    def test_a_change_names_rows_that_there_are(self):
        self.assertIn("src/scalar/quat.rs: no such row: Jia §4, moon", refused(change={"rows": ["Jia §4, moon"]}))

    def test_a_name_added_to_a_change_for_another_row_counts_for_nothing(self):
        mutations, without = falsify.table()
        other = next(mutation for mutation in mutations if FOREIGN in mutation["tests"] and mutation.get("rows"))
        other["rows"].append("Jia §4, moon")
        checked, not_read = falsify.readers()
        rows = list(falsify.claims(with_row(NONSENSE)))
        refusal = "no change is made for it, and no `checked` says why another's falsifies it: Jia §4, moon"
        self.assertEqual(falsify.check(mutations, without, rows, checked, not_read), [refusal])
        longer = falsify.check(mutations, without, rows, checked, [*not_read, "Jia §4, moon"])
        self.assertTrue(any("the list only gets shorter" in line for line in longer), longer)
        self.assertEqual(falsify.check(mutations, without, rows, checked | {"Jia §4, moon": "it is round"}, not_read), [])
        self.assertTrue(falsify.check(mutations, without, rows, checked | {"Jia §4, moon": " "}, not_read))


if __name__ == "__main__":
    unittest.main()
