"""A second Teletype on a PT08 (40, 41): the console's two interfaces again, under other codes."""

from pdp8.computer.hardware.teletype import Teletype


class PT08(Teletype):
    """The Teletype and its interfaces: 6401 to 6406 are KSF to KRB, 6411 to 6416 TSF to TLS."""

    NAME = "pt08"
    CODE = 0o40
