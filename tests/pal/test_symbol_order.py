"""The order of the symbol table, from DEC's listings: letters before digits, digits in their order."""

import pal


def test_letters_before_digits_and_8_before_9() -> None:
    tags = ["M9", "M8", "M60", "M6", "M", "MA", "M0", "A9", "A8Z", "A89", "A8"]
    source = "*200\n" + "".join(f"{tag},\t0\n" for tag in tags) + "$\n"
    order = ["A8", "A8Z", "A89", "A9", "M", "MA", "M0", "M6", "M60", "M8", "M9"]
    assert list(pal.assemble(source).symbols) == order
