"""state_document refuses wrong arguments with status 2 and one sentence, and writes no file for them."""
import os
import subprocess
import sys
import tempfile

for arguments in ([], ["--help"], ["--check"], ["--verbose", "state.md"], ["state.md", "--check", "-x"], ["a.md", "b.md"]):
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([sys.argv[1], *arguments], cwd=folder, capture_output=True, text=True)
        assert run.returncode == 2, (arguments, run)
        assert run.stderr.startswith("state_document ") and run.stderr.count("\n") == 1, (arguments, run.stderr)
        assert not os.listdir(folder), (arguments, os.listdir(folder))
