"""The C# binding: its structs have the layout of C, and a program uses the library."""
import os
import unittest

from programs import ROOT, TESTS, program, run, scratch


class Binding(unittest.TestCase):
    def test_program(self):
        mcs, mono = program("mcs"), program("mono")
        consumer = scratch() / "consumer.exe"
        run(mcs, "-unsafe", "-warnaserror", "-langversion:7", f"-out:{consumer}", ROOT / "bindings" / "csharp" / "Agaa.cs",
            TESTS / "Layout.cs", TESTS / "Consumer.cs")
        printed = run(mono, consumer, env=dict(os.environ, LD_LIBRARY_PATH=os.environ["AGAA_LIB_DIR"]))
        self.assertIn("AGAA_OK: 81 bytes per pixel", printed)


if __name__ == "__main__":
    unittest.main(verbosity=2)
