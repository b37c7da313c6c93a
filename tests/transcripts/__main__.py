"""Write what the commands of the tables answer now; of those named, or of all."""

import sys

from tests.transcripts.table import TABLES, answered

for path in TABLES:
    if path.stem in sys.argv[1:] or not sys.argv[1:]:
        path.write_text(answered(path.read_text("utf-8")), "utf-8")
