"""Make static/fonts/stix-two-math.woff from the full STIX Two Math: python -m tools.math_font path/to/full.woff

The full font is in the npm package @fontsource/stix-two-math. The result keeps the characters of formulas, with the
variants and the table that mathematical layout needs.
"""

from __future__ import annotations

import sys
from pathlib import Path

from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont

FONT = Path(__file__).parents[1] / "static" / "fonts" / "stix-two-math.woff"
CHARACTERS = (
    *range(0x20, 0x7F),
    *map(ord, "\xa0¨¯°±²³·¹¼½¾×÷˙′″⁄ℎ←↑→↓↔∂∆∑−∓∕√∝∞∣∫≈≠≡≤≥≪≫⋅\u0307\u0308"),
    *range(0x391, 0x3D7),  # Greek
    *range(0x2061, 0x2065),  # invisible operators
    *range(0x2070, 0x209D),  # superscripts and subscripts
    *range(0x239B, 0x23B4),  # parts of tall brackets
    *range(0x1D434, 0x1D468),  # italic
    *range(0x1D6A4, 0x1D71C),  # italic Greek
)
ROOT = 0.85  # em; the widest radical sign


def main(source: str) -> None:
    font = TTFont(source)
    options = Options(flavor="woff", hinting=False, layout_features=["kern", "mark", "mkmk", "ccmp", "ssty", "dtls"])
    subsetter = Subsetter(options)
    subsetter.populate(unicodes=CHARACTERS)
    subsetter.subset(font)
    narrow_roots(font)
    font.flavor = "woff"
    FONT.parent.mkdir(exist_ok=True)
    font.save(FONT)


def narrow_roots(font: TTFont) -> None:
    """Make the tall radical signs narrower: Chromium reserves the width of the widest sign for every root."""
    variants = font["MATH"].table.MathVariants
    root = variants.VertGlyphConstruction[variants.VertGlyphCoverage.glyphs.index(font.getBestCmap()[ord("√")])]
    names = {record.VariantGlyph for record in root.MathGlyphVariantRecord}
    names |= {part.glyph for part in root.GlyphAssembly.PartRecords}
    for name in names:
        width, bearing = font["hmtx"][name]
        factor = ROOT * font["head"].unitsPerEm / width
        if factor < 1:
            glyph = font["glyf"][name]
            glyph.coordinates.scale((factor, 1))
            glyph.coordinates.toInt()
            glyph.recalcBounds(font["glyf"])
            font["hmtx"][name] = (round(width * factor), round(bearing * factor))


if __name__ == "__main__":
    main(sys.argv[1])
