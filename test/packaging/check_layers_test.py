"""The check of the layers finds what it is for."""
import pathlib
import tempfile
import unittest

from check_layers import name_errors


class Names(unittest.TestCase):
    def errors_of(self, **files):
        """@param files the text within namespace ratchet_sieve of each header of the core, by its name"""
        with tempfile.TemporaryDirectory() as scratch:
            root = pathlib.Path(scratch)
            (root / "src/core").mkdir(parents=True)
            for name, text in files.items():
                (root / f"src/core/{name}.h").write_text(
                    f"#pragma once\n\nnamespace ratchet_sieve\n{{\n\n{text}\n\n}}  // namespace ratchet_sieve\n")
            return name_errors(root)

    def test_a_name_of_two_definitions_is_an_error(self):
        for text, name in (("struct Approach\n{\n  double gap;\n};", "Approach"),
                           ("template <typename T>\nclass Approach final : public Base\n{\n};", "Approach"),
                           ("struct alignas(64) Approach\n{\n};", "Approach"),
                           ("inline int half(int of,\n                int by)\n{\n  return of / by;\n}",
                            "inline int half(int of, int by)")):
            self.assertEqual(self.errors_of(a=text, b="struct Other;\n\n" + text),
                             [f"ratchet_sieve::{name}: is defined in src/core/a.h and in src/core/b.h"])

    def test_a_name_within_another_one_or_of_one_file_alone_is_none(self):
        anonymous = "namespace\n{\nstruct Approach\n{\n};\n}  // namespace"
        for text in ("struct Approach;", "struct Base::Approach\n{\n};", "struct Outer\n{\n  struct Approach\n  {\n  };\n};",
                     anonymous, "static int half(int of)\n{\n}"):
            other = text.replace("Outer", "Inner")
            self.assertEqual(self.errors_of(a=text, b=other.replace("Base", "Other")), [])


if __name__ == "__main__":
    unittest.main()
