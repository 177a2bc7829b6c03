"""Small trees with one breach each: what layers.py must find, and what it must let pass."""

import tempfile
import unittest
from pathlib import Path

import layers


class LayersTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = Path(self.folder.name)
        for layer in layers.MAY_INCLUDE:
            self.write(f"{layer}/CMakeLists.txt", "foldless_layer(x HEADERS a.h SOURCES a.cpp)\n")

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def assert_breach(self, *words):
        found = list(layers.breaches(self.root))
        self.assertEqual(len(found), 1, found)
        for word in words:
            self.assertIn(word, found[0])

    def test_a_clean_tree_passes(self):
        self.write("predicates/a.h", "#include <Eigen/Core>\n")
        self.write("io/a.h", "#include <foldless/predicates/a.h>\n#include <foldless/io/b.h>\n")
        self.write("decimate/a.cpp", "#include <foldless/io/a.h>\n")
        self.write("report/a.cpp", "#include <foldless/verify/a.h>\n  #  include <foldless/decimate/a.h>\n")
        self.assertEqual(list(layers.breaches(self.root)), [])

    def test_decimate_must_not_include_verify(self):
        self.write("decimate/a.cpp", "\n#include <foldless/verify/a.h>\n")
        self.assert_breach("decimate/a.cpp:2:", "verify is not below decimate")

    def test_verify_must_not_include_decimate(self):
        self.write("verify/a.h", "# include <foldless/decimate/a.h>\n")
        self.assert_breach("verify/a.h:1:", "decimate is not below verify")

    def test_nobody_repairs_unasked(self):
        for layer in ("decimate", "verify"):
            with self.subTest(layer=layer):
                self.write(f"{layer}/a.cpp", "#include <foldless/repair/repair.h>\n")
                self.assert_breach(f"{layer}/a.cpp:1:", f"repair is not below {layer}")
                self.write(f"{layer}/a.cpp", "")

    def test_a_layer_must_not_include_one_above(self):
        order = ["predicates", "io", "verify", "bake", "report", "tools"]
        for lower, upper in zip(order, order[1:]):
            with self.subTest(lower=lower, upper=upper):
                self.write(f"{lower}/a.h", f"#include <foldless/{upper}/a.h>\n")
                self.assert_breach(f"{lower}/a.h:1:", f"{upper} is not below {lower}")
                (self.root / lower / "a.h").unlink()

    def test_a_quoted_include_is_refused(self):
        self.write("verify/a.cpp", '#include "../decimate/a.h"\n')
        self.assert_breach("verify/a.cpp:1:", "is not included as")

    def test_a_way_around_by_dots_is_refused(self):
        self.write("verify/a.cpp", "#include <foldless/io/../decimate/a.h>\n")
        self.assert_breach("verify/a.cpp:1:", "`..`")

    def test_an_unknown_layer_is_refused(self):
        self.write("io/a.h", "#include <foldless/other/a.h>\n")
        self.assert_breach("io/a.h:1:", "no known layer")

    def test_a_file_that_is_not_listed_is_found(self):
        self.write("io/b.cpp", "")
        self.assert_breach("io/b.cpp:1:", "is not listed")

    def test_a_layer_without_a_build_file_is_found(self):
        (self.root / "io" / "CMakeLists.txt").unlink()
        self.assert_breach("io/CMakeLists.txt:1:", "is missing")

    def test_a_type_of_two_layers_is_found(self):
        self.write("decimate/a.h", "namespace foldless {\n\nclass Fan;\nstruct Place {\n")
        self.write("verify/a.h", "namespace foldless {\nclass Fan final {\nclass Place : Other {\n")
        self.assert_breach("verify/a.h:3:", "foldless::Place", "decimate/a.h")

    def test_types_of_one_name_in_two_namespaces_pass(self):
        self.write("decimate/a.h", "namespace foldless::one {\nstruct Place {\n")
        self.write("verify/a.h", "namespace foldless::two {\nstruct Place {\n")
        self.assertEqual(list(layers.breaches(self.root)), [])


if __name__ == "__main__":
    unittest.main()
