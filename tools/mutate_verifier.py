#!/usr/bin/env python3
"""What the tests of the verifier are worth: breaks each comparison, bound and inclusion of its
sources once, and lists the mutants that no test notices.

    tools/mutate_verifier.py BUILD [FILE[:LINE[-LINE]] ...]     e.g. build/dev regular_claim.cpp

BUILD is a directory where ninja has built blends_verification_test; FILEs are sources or headers of
blends/src/verification, all of them if none is given. Of a source, gcov says first which tests
run which of its functions, and a mutant is put to those. Of a header, all sources of the checker and
of the test that include it are compiled again, and all tests are run. A mutant that does not
compile, crashes the test or takes ten times as long counts as noticed. KNOWN lists survivors that
are right as they are, each with its reason; the exit code is 1 if there are others, and 2 if an
entry is not about one mutant.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import typing

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCES = ROOT / "blends/src/verification"
# By their names, of which there is one each.
FILES = {p.name: p for p in sorted(SOURCES.rglob("*.*")) if p.suffix in (".cpp", ".h")}
TEST = "tests/blends/blends_verification_test"
SWAPS = [(" < ", " <= "), (" <= ", " < "), (" > ", " >= "), (" >= ", " > "), (" == ", " != "),
         (" != ", " == "), (" && ", " || "), (" || ", " && "), (".lower", ".upper"),
         (".upper", ".lower"), ("std::max(", "std::min("), ("std::min(", "std::max("),
         (" max(", " min("), ("all_of(", "any_of("), ("any_of(", "all_of("),
         ("return false", "return true"), ("return true", "return false"), ("!(", "("),
         ("lower_bound(", "upper_bound("), ("upper_bound(", "lower_bound(")]
# (file, what the line contains as it is or as it becomes, what is put in): why nothing can notice.
SLACK = "the slack has no meaning to the last bit"
REGULAR = "a claim of its own says that radii are positive"
ADMITTED = "radii of ends are admitted as positive, and so are those between"
ROUNDING = "the two differ by rounding only"
STRICTER = "it can only refuse more, and later cells say the same"
DEPTH = "to halve once more changes no answer but of what is nearly too much"
ACROSS = "a tangent that may be across has 1 among its sines, or has no quotient: the line"
ONE_SIDE = "no point is on both sides of a plane"
LINE = "a quotient by what may be 0 is the line, from which nothing follows"
ROUNDED_DOWN = "a bound is rounded down, to less than 0 where it is 0"
INSIDE = "what bounds the inside of arcs bounds their ends, too"
POINT = "a circle without radius is a point, of which the bounds hold, too"
ONE_PAIR_MORE = "a pair more needs a claim of its own"
ORDER = "how parts are halved changes the work, and no pair is lost"
AGAIN = "what is stopped is asked again in its turn"
NOT_ENDED = "a block that is asked for has not ended"
TO_THE_UNIT = "work ahead is bounded, but not to the last unit"
IRRATIONAL = "of doubles and pi, 128 bits tell which is larger"
NEARLY_ROUND = "semi-axes of arcs are admitted as equal but for rounding"
NO_SHARE = "a share that is not positive is refused, be it 0 or less"
LENGTH = "what arcs are found to move along has a length"
KNOWN = {
    ("admitted.cpp", "std::abs(s.axis.dot(spoke)) <= kUnitSlack", " < "): SLACK,
    ("admitted.cpp", "std::abs(v.stableNorm() - 1) <= kUnitSlack", " < "): SLACK,
    ("admitted.cpp", "ellipse->axis.dot(r.normal)) <= kUnitSlack", " < "): SLACK,
    ("covering.cpp", "while (width_ < cells) {", " <= "):
        "a wider tree has cells that nobody asks for",
    ("covering.cpp", "if (leaf.first.from <= leaf.first.to", " <= "): "an empty leaf adds nothing",
    ("covering.cpp", "leaf.second.from <= leaf.second.to", " <= "): "an empty leaf adds nothing",
    ("covering.cpp", "if (leaf.first.from < leaf.first.to", " || "):
        "a leaf whose ends are exchanged takes away before it adds",
    ("covering.cpp", "std::max(lowest, above > 0", " >= "): "the lowest cut is never above",
    ("covering.cpp", "if (from <= highest && counts", " <= "):
        "no strip that is asked for begins where the last cell ends",
    ("covering.cpp", "return a.at < b.at; });", " <= "): "the order of equal events is free",
    ("covering.cpp", "reached < first.to;) {", " <= "): "strips beyond the end are of no width",
    ("regular_claim.cpp", "if (range.lower > 0 && all_positive(excess", " >= "): ADMITTED,
    ("regular_claim.cpp", "if (range.lower > 0 && all_positive(excess", ".upper"): ADMITTED,
    ("regular_claim.cpp", "- disc->radius[0] * turning).lower > 0) {", " >= "):
        ROUNDED_DOWN,
    ("regular_claim.cpp", "return least > 0 &&", " >= "): ADMITTED,
    ("regular_claim.cpp", "return halvings > 0 && is_regular_on(tube,", " >= "): DEPTH,
    ("regular_claim.cpp", "return halvings > 0 && is_regular_on(motion,", " >= "): DEPTH,
    ("regular_claim.cpp", "least = tube.radius_range(t, t).lower;", ".upper"): ROUNDING,
    ("pair_claims.cpp", "cells <= kMostCells; cells *= 2", " < "): STRICTER,
    ("pair_claims.cpp", "cells <= kMostCells; cells *= 4", " < "): STRICTER,
    ("pair_claims.cpp", "length.lower > 0 ?", " >= "): "a quotient by what may be 0 is the line",
    ("pair_claims.cpp", "width = length.upper > 0 ?", ".upper"): LINE,
    ("pair_claims.cpp", "((-front - behind) / length).upper : -1;", ".upper"): ROUNDING,
    ("pair_claims.cpp", "if (width > 0 && width >= distance) {", " >= "):
        "a width is rounded down, to less than 0 where it is 0",
    ("pair_claims.cpp", "if (width > 0 && width >= distance) {", " > "): SLACK,
    ("pair_claims.cpp", "tangents) <= std::numbers::pi / 2", " < "): SLACK,
    ("pair_claims.cpp", "return room && room->least > 0 &&", " >= "): ROUNDED_DOWN,
    ("pair_claims.cpp", "if (!room || !(room->least > 0))", " >= "): ROUNDED_DOWN,
    ("pair_claims.cpp", "Mpfi::pi()).upper < 0;", " <= "): IRRATIONAL,
    ("pair_claims.cpp", "Mpfi::pi()).upper < 0;", ".lower"): IRRATIONAL,
    ("pair_claims.cpp", "Mpfi::pi() / 2).upper < 0", " <= "): IRRATIONAL,
    ("pair_claims.cpp", "Mpfi::pi() / 2).upper < 0", ".lower"): IRRATIONAL,
    ("pair_claims.cpp", "return range.lower > 0 &&", " >= "): REGULAR,
    ("pair_claims.cpp", "return range.lower > 0 &&", ".upper"): REGULAR,
    ("pair_claims.cpp", "* range.upper).upper <= range.lower", " < "): SLACK,
    ("pair_claims.cpp", "!(disc->radius[0].lower > 0)", " >= "): REGULAR,
    ("pair_claims.cpp", "!(disc->radius[0].lower > 0)", ".upper"): REGULAR,
    ("pair_claims.cpp", "radius = std::max(radius.lower, disc->radius[0].upper);", ".lower"):
        "the largest radius so far is one number; tests notice if the other is the lower",
    ("pair_claims.cpp", "magnitude(), max(a, b).lower}", ".lower"): NEARLY_ROUND,
    ("pair_claims.cpp", "magnitude(), min(a, b).upper}", " min("): NEARLY_ROUND,
    ("pair_claims.cpp", "room->difference) / room->largest)", ".upper"): ROUNDING,
    ("pair_claims.cpp", "return first || last ? numbers::norm(", " || "):
        "discs at ends are known where those of all cells are, and those along lines and arcs",
    ("pair_claims.cpp", "return first && last ? numbers::norm(", ".upper"): ROUNDING,
    ("pair_claims.cpp", "return loss.lower;", ".lower"): ROUNDING,
    ("pair_claims.cpp", "least = std::min(least, rest.", " >= "): NO_SHARE,
    ("pair_claims.cpp", "rest.upper > 0 ? (rest / speed).lower : 0", ".upper"): NO_SHARE,
    ("pair_claims.cpp", "rest.lower > 0 ? (rest / speed).upper : 0", ".upper"): ROUNDING,
    ("pair_claims.cpp", "if (!(share.upper > 0 &&", ".upper"): "a share is one number",
    ("pair_claims.cpp", "chord(way[i]) - loss).lower >= 0", " >= "): SLACK,
    ("pair_claims.cpp", "chord(way[i]) - loss).upper > 0", ".upper"): ROUNDING,
    ("pair_claims.cpp", "if (!(shares.at(i) >= 0)) {", " >= "): NO_SHARE,
    ("pair_claims.cpp", "std::max(radius.lower, tube.radius_range(", ".lower"):
        "the largest radius so far is one number",
    ("pair_claims.cpp", "phi = phi.upper;", ".lower"): ROUNDING,
    # phi is one number by then
    ("pair_claims.cpp", "i = 0; phi.upper < 1", ".lower"): ROUNDING,
    ("pair_claims.cpp", "return phi.upper < 1", ".lower"): ROUNDING,
    # all that they are made of are single numbers
    ("pair_claims.cpp", "return share.upper > 0 &&", ".upper"): ROUNDING,
    ("pair_claims.cpp", "- loss).upper > 0;", ".upper"): ROUNDING,
    ("pair_claims.cpp", "return share.lower >= 0 &&", " >= "): SLACK,
    ("pair_claims.cpp", "- loss).lower >= 0;", " >= "): SLACK,
    ("pair_claims.cpp", "numbers::dot(sum, tangent).lower >= 0;", " >= "): SLACK,
    ("pair_claims.cpp", "* range.upper).lower <= range.lower", ".lower"): ROUNDING,
    ("pair_claims.cpp", "|| !first && !last) {", " && "):
        "of one disc no point is on both sides; without `discs` an empty optional is read, whose"
        " garbage a test asks for and need not accept; and ends are known where `discs` are",
    ("pair_claims.cpp", "if (!(t.from < t.to) || !discs", " <= "): ONE_SIDE,
    ("pair_claims.cpp", "first->tangents.front()).lower > 0", " >= "): SLACK,
    ("pair_claims.cpp", "first->tangents.front()).lower > 0", ".upper"): ROUNDING,
    ("pair_claims.cpp", "last->tangents.back()).upper < 0", " <= "): SLACK,
    ("pair_claims.cpp", "last->tangents.back()).upper < 0", ".lower"): ROUNDING,
    ("pair_claims.cpp", "const Interval cosine =", ".upper"): ROUNDING,
    ("pair_claims.cpp", "i = 0; phi.upper <= 1", " <= "): SLACK,
    ("pair_claims.cpp", "return phi.upper <= 1", " <= "): SLACK,
    ("pair_claims.cpp", "norm(box - center).upper < discs->radius.lower", " <= "):
        "a point of the border is in the disc too",
    ("pair_claims.cpp", "overlap->first.to < claim.overlap->second.from", " <= "): ONE_SIDE,
    ("pair_claims.cpp", "overlap->second.to < claim.overlap->first.from", " <= "): ONE_SIDE,
    ("loop_clearance.cpp", "points.empty() || !(length.lower > 0)", " >= "): LENGTH,
    ("loop_clearance.cpp", "points.empty() || !(length.lower > 0)", ".upper"): LENGTH,
    ("tangency_claim.cpp", "norm(part(disc->normal, 1)).upper", ".lower"): ROUNDING,
    ("tangency_claim.cpp", "cross(part(disc->normal, 2), n)).upper", ".lower"): ROUNDING,
    ("tangency_claim.cpp", "return q.lower > 0 &&", " >= "): SLACK,
    ("tangency_claim.cpp", ".magnitude() <= claimed;", " < "): SLACK,
    ("tangency_claim.cpp", "found.offset.rounded_outward().upper", " < "): SLACK,
    ("tangency_claim.cpp", "found.offset.rounded_outward().upper", ".lower"): ROUNDING,
    ("tube.cpp", "if (arc.angle * (to - from) > kLargestTurn", " >= "): DEPTH,
    ("tube.cpp", "with = with && cosine.lower > 0;", " >= "): ACROSS,
    ("tube.cpp", "with = with && cosine.lower > 0;", ".upper"): ACROSS,
    ("tube.cpp", "against = against && cosine.upper < 0;", " <= "): ACROSS,
    ("tube.cpp", "against = against && cosine.upper < 0;", ".lower"): ACROSS,
    ("tube.cpp", "sine = scale.lower > 0", " >= "): ACROSS,
    ("tube.cpp", "sine = scale.lower > 0", ".upper"): ACROSS,
    ("tube.cpp", "(Interval(sine) + discs.spread).upper", ".lower"): ROUNDING,
    ("piece.cpp", "return x.rounded_outward().upper; }", ".lower"): ROUNDING,
    ("piece.cpp", "std::max((Interval(t.to) - middle).lower", ".lower"): ROUNDING,
    ("piece.cpp", "(Interval(middle) - t.from).lower)", ".lower"): ROUNDING,
    ("piece.cpp", "std::max((Interval(t.to) - middle).upper", "std::min("): ROUNDING,
    ("mesh_claim.cpp", "const Interval around = Interval(2) * Interval(pi", ".upper"): ROUNDING,
    ("mesh_claim.cpp", "const Interval around = Interval(2) * Interval(pi", ".lower"): ROUNDING,
    ("mesh_claim.cpp", "bounds.around = std::max(bounds.around, radius.upper);", ".lower"):
        "a magnitude is one number",
    ("mesh_claim.cpp", "bounds.mixed = std::max(bounds.mixed, (slope + radius * rate)", ".lower"):
        ROUNDING,
    ("mesh_claim.cpp", "numbers::sqrt(square(slope) + square(radius * turn))", ".lower"): ROUNDING,
    ("mesh_claim.cpp", "bounds.turning = std::max(bounds.turning, turn.upper);", ".lower"):
        "a magnitude is one number",
    ("mesh_claim.cpp", "for (int i = 0; i <= cells; ++i) {", " <= "):
        "a cell behind the band can only add to the bounds",
    ("mesh_claim.cpp", "is_by_length = measure != Measure::length", " != "): "both are tried",
    ("mesh_claim.cpp", "return turn.upper < 1 &&", " < "): SLACK,
    ("mesh_claim.cpp", "&& error.upper < allowed;", " < "): SLACK,
    ("mesh_claim.cpp", "return turn.lower <= 1 &&", ".lower"): ROUNDING,
    ("mesh_claim.cpp", "&& error.lower <= allowed;", ".lower"): ROUNDING,
    ("mesh_claim.cpp", "{twist.lower, twist.upper}", ".upper"): ROUNDING,
    ("mesh_claim.cpp", "{twist.lower, twist.upper}", ".lower"): ROUNDING,
    ("mesh_claim.cpp", "size)).upper <= claim.error_bound;", " < "): SLACK,
    ("mesh_claim.cpp", "size)).upper <= claim.error_bound;", ".lower"): ROUNDING,
    ("mesh_claim.cpp", "- turned - apart - moved).lower;", ".upper"): ROUNDING,
    ("mesh_claim.cpp", "(Interval(knee.radius) - solid.wall()).upper", ".lower"): ROUNDING,
    ("mesh_claim.cpp", "return disc && disc->radius[0].lower >= 0;", " > "): SLACK,
    ("mesh_claim.cpp", "return disc && disc->radius[0].lower >= 0;", ".upper"): ROUNDING,
    ("mesh_claim.cpp", "numbers::norm(numbers::interval_vec(knee.center)).upper", ".lower"): ROUNDING,
    ("mesh_claim.cpp", "!(sagitta(radius, segments) <= allowed)", " < "): SLACK,
    ("mesh_claim.cpp", "cells <= 1 << kRefinements; cells *= 2", " < "): STRICTER,
    ("mesh_claim.cpp", "return sagitta(largest_radius(piece), segments) <= allowed;", " < "): SLACK,
    ("mesh_claim.cpp", "return depth.rounded_outward().upper;", ".lower"): ROUNDING,
    ("mesh_claim.cpp", "std::min(1., plane.rounded_outward().lower)", ".upper"): ROUNDING,
    ("certificate_verify.cpp", "(first > parts || !is_on(", " > "):
        "no fillet is on what comes after the parts",
    ("certificate_verify.cpp", "k <= surfaces", " <= "): "what is no loop makes no pair",
    ("certificate_verify.cpp", "j <= surfaces", " <= "): "what is no loop makes no pair",
    ("near_parts.cpp", "return place_of(a, solids.size()) <= place_of(b", " <= "):
        "no two pairs have one place",
    ("mesh_claim.cpp", "!(std::abs(tube->turn) <= 1)", " <= "):
        "any number between 0 and pi tells the multiples apart",
    ("motion.cpp", "q[0].size() < kMostCoefficients", " < "):
        "without it the same derivatives are enclosed, only more widely",
    ("motion.cpp", "return {-bound.lower,", ".lower"): ROUNDING,
    ("motion.cpp", "-bound.upper, bound.lower};", ".lower"): ROUNDING,
    ("near_parts.cpp", "between.lower > distance", " > "): ONE_PAIR_MORE,
    ("solid.cpp", "return size > 0 ? size", " > "): "the box of a piece is no point",
    ("solid.cpp", ".upper < tolerance);", " < "): SLACK,
    ("near_parts.cpp", "between.upper < -distance", " < "): ONE_PAIR_MORE,
    ("near_parts.cpp", "return std::isfinite(x.lower) && std::isfinite(x.upper)", " || "):
        "only a middle of two infinite ends is no number",
    ("near_parts.cpp", "isfinite(x.lower) && std::isfinite(x.lower)", ".lower"): ORDER,
    ("near_parts.cpp", "std::midpoint(x.lower, x.lower)", ".lower"): ORDER,
    ("near_parts.cpp", "isfinite(x.upper) && std::isfinite(x.upper)", ".upper"): ORDER,
    ("near_parts.cpp", "std::midpoint(x.upper, x.upper)", ".upper"): ORDER,
    ("near_parts.cpp", "width(0) > width(1)", " > "): ORDER,
    ("near_parts.cpp", "width(axis) > width(2)", " > "): ORDER,
    ("near_parts.cpp", "if (parts.size() >= kFew) {", " >= "): ORDER,
    ("near_parts.cpp", "if (std::max(a.size(), b.size()) > kFew) {", "std::max("): ORDER,
    ("near_parts.cpp", "if (std::min(a.size(), b.size()) >= kFew) {", " >= "): ORDER,
    ("near_parts.cpp", "splits_first = a.size() > b.size();", " > "): ORDER,
    ("tube.cpp", "x.lower, x.lower)", ".lower"):
        "only the upper end of the angle is asked for, which the lower end of x decides",
    ("motion.cpp", "!(squared[0].lower >= 0)", " >= "): LINE,
    ("motion.cpp", "!(squared[0].upper > 0)", ".upper"): LINE,
    ("motion.cpp", "if (!(w[0].lower > 0)) {", " >= "): LINE,
    ("motion.cpp", "if (!(w[0].lower > 0)) {", ".upper"): LINE,
    ("motion_cyclide.cpp", "if (!(w[0].lower > 0)) {", " >= "): LINE,
    ("motion_cyclide.cpp", "if (!(w[0].lower > 0)) {", ".upper"): LINE,
    ("motion_cyclide.cpp", "squared_pace[0].lower >= 0)", " >= "):
        "circles of no radius are known then, and nothing of how they move",
    ("motion.cpp", "is_rational = s.weight.size() >= 1,", " >= "): ROUNDING,
    ("fillet_claims.cpp", "return speed.lower >= 0;", " >= "): ROUNDED_DOWN,
    ("fillet_claims.cpp", "phi = phi.lower;", ".lower"): ROUNDING,
    ("fillet_claims.cpp", "square(phi) / 2).upper;", ".upper"): ROUNDING,
    ("fillet_claims.cpp", "return phi.upper <= 1 &&", " <= "): SLACK,
    ("fillet_claims.cpp", "return phi.lower < 1 &&", ".lower"): ROUNDING,
    ("fillet_claims.cpp", "sideways.upper * phi).lower >= 0;", " >= "): SLACK,
    ("fillet_claims.cpp", "sideways.upper * phi).upper > 0;", ".upper"): ROUNDING,
    ("fillet_claims.cpp", "furthest(second, Interval(-1) * d)).upper <= 0;", " <= "): SLACK,
    ("fillet_claims.cpp", "furthest(second, Interval(-1) * d)).lower < 0;", ".lower"): ROUNDING,
    ("fillet_claims.cpp", "off.value.magnitude() < claim.offset", " < "): SLACK,
    ("fillet_claims.cpp", "deviation.upper < claim.deviation", " < "): SLACK,
    ("fillet_claims.cpp", "return halvings >= 0 && holds_halved(", " >= "): DEPTH,
    ("fillet_claims.cpp", "beyond(starts.at(side), foot)) < tolerance", " < "): SLACK,
    ("fillet_claims.cpp", "angle(Mpfi(chord.upper), Mpfi(rest.upper))", ".upper"): ROUNDING,
    ("rolling_balls.cpp", "if (from < 0.5 && to >= 0.5) {", " < "): ROUNDING,
    ("rolling_balls.cpp", "if (from <= 0.5 && to > 0.5) {", " > "): ROUNDING,
    ("rolling_balls.cpp", "(Interval(to) - from) / squared).lower;", ".lower"): ROUNDING,
    ("rolling_balls.cpp", "const Interval falling{last.cosine.", ".upper"): ROUNDING,
    ("rolling_balls.cpp", "const Interval falling{last.cosine.", ".lower"): ROUNDING,
    ("rolling_balls.cpp", "const Interval rising{first.sine.", ".upper"): ROUNDING,
    ("rolling_balls.cpp", "const Interval rising{first.sine.", ".lower"): ROUNDING,
    ("contact_arcs.cpp", "balls.radius[0].lower >= 0", " >= "): POINT,
    ("contact_arcs.cpp", "square(growth[0])).lower >= 0", " >= "): LINE,
    ("contact_arcs.cpp", "if (!(length[0].lower >= 0)) {", " >= "): LINE,
    ("contact_arcs.cpp", "if (!(length[0].upper > 0)) {", ".upper"): LINE,
    ("contact_arcs.cpp", "if (!(squared_sum[0].lower >= 0)) {", " >= "): LINE,
    ("contact_arcs.cpp", "if (!(squared_sum[0].upper > 0)) {", ".upper"): LINE,
    ("contact_arcs.cpp", "ends.at(1 - i)).upper < 0) {", " < "): "the wider of two bounds",
    ("contact_arcs.cpp", "const double wide = most >= 0 ?", " >= "): ROUNDING,
    ("contact_arcs.cpp", "inverse_cosine.upper).lower : most", ".lower"): ROUNDING,
    ("contact_arcs.cpp", "const bool falls = arcs.bending.upper >=", " >= "): INSIDE,
    ("contact_arcs.cpp", "bending.upper > std::max(bending[0].lower,", ".lower"): INSIDE,
    ("contact_arcs.cpp", "bending.upper > std::max(bending[0].upper, bending[1].lower", ".lower"): INSIDE,
    ("contact_arcs.cpp", "bending.upper > std::min(", "std::min("): INSIDE,
    ("contact_arcs.cpp", "if (!turn && !middle_turn", " && "):
        "what lies in one half of a loop has its middle there",
    ("hub_claims.cpp", "square(r1)).lower >= 0)", " >= "): POINT,
    ("hub_claims.cpp", "!(sphere.radius[0].lower >= 0)", " >= "): POINT,
    ("hub_claims.cpp", ".lower >= 0;", " >= "): SLACK,
    ("hub_claims.cpp", "normal) + reach).upper <= 0;", " < "): SLACK,
    ("hub_claims.cpp", "s_root.is_positive() || t_root.is_positive();", " || "):
        "what is negative times what is not has no root then: the line, which is not positive",
    ("hub_claims.cpp", "Interval(depth.rounded_outward().lower)", ".lower"): ROUNDING,
    ("hub_claims.cpp", "size)).upper < claim.error_bound;", " < "): SLACK,
    ("hub_claims.cpp", "size)).lower <= claim.error_bound;", ".lower"): ROUNDING,
    ("loop_clearance.cpp", "length.lower >= 0 ?", " >= "): LINE,
    ("loop_clearance.cpp", "length.upper > 0 ?", ".upper"): LINE,
    ("loop_clearance.cpp", "((-front - behind) / length).upper", ".upper"): ROUNDING,
    ("loop_clearance.cpp", "return width >= 0 &&", " >= "): ROUNDED_DOWN,
    ("loop_clearance.cpp", "width > distance;", " > "): SLACK,
    ("taylor_jet.h", "static_assert(count < more);", " <= "):
        "of as many derivatives the last is what is given, without the formula",
    ("certificate_verify.cpp", "contact->offset < tolerance", " < "): SLACK,
    ("certificate_verify.cpp", "claim.corner < certificate.tolerance", " < "): SLACK,
    ("bernstein.h", "for (std::size_t k = 0; k < m + n; ++k) {", " < "): "the last one is divided by 1",
    ("fillet_claims.cpp", "angle(Mpfi(chord.lower), Mpfi(rest.lower))", ".lower"): ROUNDING,
    ("fillet_claims.cpp", "Mpfi(rest.lower))).lower;", ".lower"): ROUNDING,
    ("fillet_claims.cpp", "cell.around = (radius * square(arc)).lower;", ".lower"): ROUNDING,
    ("fillet_claims.cpp", "displacement(claim.grid, size)).lower;", ".lower"): ROUNDING,
    ("fillet_claims.cpp", "!(arcs->passing.lower >= (Interval(margin)", " >= "): SLACK,
    ("certificate_verify.cpp", "require(*arm <= hub &&", " <= "): "a hub is a sphere and no arm",
    ("work.cpp", "open_ < block && done_[open_]", " <= "): NOT_ENDED,
    ("work.cpp", "return block > first_failed_", " >= "): NOT_ENDED,
    ("work.cpp", "at != nullptr && !at->blocks->is_behind_failed", " == "): AGAIN,
    ("work.cpp", "return at != nullptr;", " == "): AGAIN,
    ("work.cpp", "if (ahead.spent <= ahead.most)", " < "): TO_THE_UNIT,
    ("work.cpp", "if (spent > at->left)", " >= "):
        "threads would have to be beyond what they may spend just when one has its turn and nothing left",
    ("work.cpp", "turn->unsaid > kUnsaid", " >= "): TO_THE_UNIT,
    ("work.cpp", "if (block_count <= 1)", " < "): "one block is found in its turn, too",
}


# Of several lines that read alike, for the same reason.
TWINS = {
    ("hub_claims.cpp", ".lower >= 0;", " >= "): 3,
    ("mesh_claim.cpp", "bounds.around = std::max(bounds.around, radius.upper);", ".lower"): 2,
    ("motion.cpp", "!(squared[0].lower >= 0)", " >= "): 5,
    ("motion.cpp", "!(squared[0].upper > 0)", ".upper"): 5,
}


class Mutant(typing.NamedTuple):
    number: int
    line: str
    changed: str
    new: str


def mutants(text):
    """Pairs of a description and a changed text; comments and includes are left alone."""
    lines = text.split("\n")
    for number, line in enumerate(lines):
        code = line.split("//")[0]
        if code.lstrip().startswith("#"):
            continue
        for old, new in SWAPS:
            for found in re.finditer(re.escape(old), code):
                changed = code[:found.start()] + new + code[found.end():]
                yield (Mutant(number + 1, line.strip(), changed.strip(), new),
                       "\n".join(lines[:number] + [changed] + lines[number + 1:]))


def linking(build):
    """Objects and libraries of the test, as ninja links them."""
    text = (build / "build.ninja").read_text()
    block = re.search(r"^build %s:.*?\n\n" % re.escape(TEST), text, re.M | re.S).group(0)
    objects = [w for w in block.split("|")[0].split() if w.endswith(".o")]
    libraries = re.search(r"LINK_LIBRARIES = (.*)", block).group(1).split()
    return objects, libraries


def output(entry):
    """What a compiler's call writes, as ninja names it."""
    words = entry["command"].split()
    return words[words.index("-o") + 1]


def users(build, header, entries):
    """The sources of the checker and of the test whose objects depend on a header."""
    deps = subprocess.run(["ninja", "-t", "deps"], cwd=build, capture_output=True, text=True, check=True).stdout
    ours = linking(build)[0]
    source_of = {output(e): f for f, e in entries.items() if f.startswith(str(SOURCES)) or output(e) in ours}
    found = []
    for block in deps.split("\n\n"):
        target, _, rest = block.partition(":")
        if target in source_of and FILES[header] in {(build / line.strip()).resolve()
                                                    for line in rest.split("\n")[1:]}:
            found.append(source_of[target])
    return found


def prepare(build, folder, command):
    """What all mutants share: the headers compiled before, and libraries without debug symbols."""
    found = {i for p in FILES.values() if p.suffix == ".cpp"
             for i in re.findall(r"^#include <.*>", p.read_text(), re.M)}
    shared = [f'#include "{name}"' for name in
              ("numbers/interval.h", "numbers/mpfi_interval.h", "dupin/blends/certificate.h")]
    header = folder / "shared.h"
    header.write_text("\n".join(sorted(found) + shared) + "\n")
    subprocess.run([*command, "-x", "c++-header", header, "-o", f"{header}.gch"],
                   cwd=build, check=True)
    objects, libraries = linking(build)
    files = []
    for i, name in enumerate([*objects, *libraries]):
        if name.startswith(("-", "/")):
            files.append(name)
            continue
        files.append(folder / f"{i}{pathlib.Path(name).suffix}")
        subprocess.run(["strip", "-g", "-o", files[-1], build / name], check=True)
    return files


def compiling(entry):
    """The compiler's call for one of the sources, quick instead of optimised."""
    words = re.sub(r"^\S*ccache\s+", "", entry["command"]).split()
    drop = [i for i, w in enumerate(words) if w in ("-include", "-o", "-c")]
    drop = {j for i in drop for j in (i, i + 1)}
    unwanted = ("-W", "-O", "-g", "-fpch")
    return [w for i, w in enumerate(words) if i not in drop and not w.startswith(unwanted)] + ["-w", "-D_GLIBCXX_ASSERTIONS"]


class Tests:
    """The tests of the program: how long each takes, and which of a source's functions it runs."""

    QUICK = 0.2  # seconds; these are asked first

    def __init__(self, program):
        self.program = program
        listed = subprocess.run([program, "--gtest_list_tests"], capture_output=True, text=True, check=True).stdout
        self.seconds, suite = {}, ""
        for line in listed.split("\n")[1:]:
            word = line.split("#")[0].strip()
            if not line.startswith(" "):
                suite = word
            elif word:
                self.seconds[suite + word] = 0.0
        self.functions = None  # (first line, last line, test)

    def time_all(self):
        self.time(subprocess.run([self.program], capture_output=True, text=True, check=True).stdout)

    def time(self, printed):
        for test, time in re.findall(r"^\[ +OK \] (\S+)(?:, where.*)? \((\d+) ms\)", printed, re.M):
            self.seconds[test] = int(time) / 1000

    def cover(self, unit, jobs):
        """Runs all tests of a program whose `unit`.o was compiled for gcov."""
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            self.functions = [f for found in pool.map(lambda t: self.run_by(t, unit), list(self.seconds)) for f in found]

    def run_by(self, test, unit):
        with tempfile.TemporaryDirectory() as prefix:
            run = subprocess.run([self.program, f"--gtest_filter={test}"], capture_output=True, text=True, check=True,
                                 env={**os.environ, "GCOV_PREFIX": prefix})
            self.time(run.stdout)
            data = pathlib.Path(prefix + str(unit.with_suffix(".gcda")))
            if not data.exists():
                return []
            shutil.copy(unit.with_suffix(".gcno"), data.parent)
            found = json.loads(subprocess.run(["gcov", "--json-format", "--stdout", data], cwd=prefix, text=True,
                                              capture_output=True, check=True).stdout)
        return [(f["start_line"], f["end_line"], test) for file in found["files"]
                if pathlib.Path(file["file"]).name == unit.name.split(".")[0] + ".cpp"
                for f in file["functions"] if f["execution_count"] > 0]

    def of(self, number, function_lines):
        """Those to put to a mutant of this line: all of what is in no function."""
        if self.functions is None or number not in function_lines:
            return list(self.seconds)
        return sorted({test for first, last, test in self.functions if first <= number <= last})

    def notice(self, program, tests, label):
        quick = [t for t in tests if self.seconds[t] <= self.QUICK]
        for part in (quick, [t for t in tests if t not in quick]):
            if not part:
                continue
            limit = 5 + 10 * sum(self.seconds[t] for t in part)
            try:
                if subprocess.run([program, "--gtest_fail_fast", f"--gtest_filter={':'.join(part)}"],
                                  capture_output=True, timeout=limit).returncode:
                    return True
            except subprocess.TimeoutExpired:
                print(f"{label}: takes too long", flush=True)  # noticed, unless the machine is busy
                return True
        return False


class Mutation:
    """Compiles and runs what one file of the checker becomes."""

    def __init__(self, build, folder, entries, jobs):
        self.build, self.folder, self.jobs = build, folder, jobs
        self.entries = entries
        self.command = compiling(entries[str(FILES["work.cpp"])])
        self.files = prepare(build, folder, self.command)
        self.names = linking(build)[0]
        self.linker = ["-fuse-ld=lld"] if shutil.which("ld.lld") else []

    def compiled(self, place, sources, name, text, flags=()):
        """The objects by source; none if one does not compile."""
        overlay = place / "overlay"
        changed = overlay / FILES[name].relative_to(SOURCES.parent)
        changed.parent.mkdir(parents=True)
        changed.write_text(text)
        objects = {}
        for source in sources:
            objects[source] = place / f"{pathlib.Path(source).stem}.mutant.o"
            given = changed if source == str(FILES[name]) else source
            command = compiling(self.entries[source])
            run = subprocess.run([command[0], "-I", overlay, *command[1:], *flags, "-include",
                                  self.folder / "shared.h", "-c", given, "-o", objects[source]],
                                 cwd=self.build, capture_output=True)
            if run.returncode:
                return None
        return objects

    def program(self, place, name, text, sources, flags=()):
        """None if it does not compile."""
        objects = self.compiled(place, sources, name, text, flags)
        if objects is None:
            return None
        tests = {output(self.entries[s]): objects[s] for s in objects}
        own = [tests.pop(n, f) for n, f in zip(self.names, self.files)]
        own.sort(key=lambda o: o not in objects.values())  # whose inline functions are taken
        subprocess.run(["c++", *self.linker, *flags, "-o", place / "test", *own, *tests.values(),
                        *self.files[len(self.names):]], cwd=self.build, check=True)
        return place / "test"

    def tests_of(self, name, text, sources):
        """The tests, and the lines of the file that are in functions."""
        place = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        if not name.endswith(".cpp"):
            tests = Tests(self.program(place, name, text, sources))
            tests.time_all()
            return tests, set()
        tests = Tests(self.program(place, name, text, sources, ["--coverage"]))
        unit = place / f"{pathlib.Path(name).stem}.mutant.o"
        tests.cover(unit, self.jobs)
        lines = json.loads(subprocess.run(["gcov", "--json-format", "--stdout", unit.with_suffix(".gcno")], cwd=place,
                                          text=True, capture_output=True, check=True).stdout)
        return tests, {n for file in lines["files"] if pathlib.Path(file["file"]).name == name
                       for f in file["functions"] for n in range(f["start_line"], f["end_line"] + 1)}

    def is_noticed(self, name, text, sources, tests, asked, label):
        with tempfile.TemporaryDirectory(dir=self.folder) as place:
            program = self.program(pathlib.Path(place), name, text, sources)
            return program is None or tests.notice(program, asked, label)


def is_about(key, name, mutant):
    file, where, what = key
    return file == name and what == mutant.new and (where in mutant.line or where in mutant.changed)


def known_reason(name, mutant):
    return next((why for key, why in KNOWN.items() if is_about(key, name, mutant)), None)


def misplaced_reasons():
    """Of KNOWN, what is of no mutant of the sources as they are, or of several: it would excuse others."""
    found = []
    for name in sorted({key[0] for key in KNOWN} - FILES.keys()):
        found.append(f"{name}: there is no such source")
    for name in sorted({key[0] for key in KNOWN} & FILES.keys()):
        of_file = [mutant for mutant, _ in mutants(FILES[name].read_text())]
        for key in (key for key in KNOWN if key[0] == name):
            lines = [mutant.number for mutant in of_file if is_about(key, name, mutant)]
            if len(lines) != TWINS.get(key, 1):
                found.append(f"{name}: {key[1:]} is about {len(lines)} mutants, of lines {lines}")
    return found


def survivors_of(mutation, asked, skip_known):
    """Runs the mutants of FILE[:LINE[-LINE]] and returns how many there were, and how many survived
    with a reason and without one."""
    name, _, only = asked.partition(":")
    first, _, last = only.partition("-")
    original = FILES[name].read_text()
    sources = [str(FILES[name])] if name.endswith(".cpp") else users(mutation.build, name, mutation.entries)
    all_of_it = [(m, text) for m, text in mutants(original)
                 if not only or int(first) <= m.number <= int(last or first)]
    ours = [(m, text) for m, text in all_of_it if not skip_known or known_reason(name, m) is None]
    tests, lines = mutation.tests_of(name, original, sources) if ours else (None, set())

    # Most mutants of a header are noticed when its own test alone is compiled again.
    own_test = [s for s in sources if pathlib.Path(s).name.startswith(f"{pathlib.Path(name).stem}_internal_test")]

    def survives(of_ours):
        mutant, text = of_ours
        asked = tests.of(mutant.number, lines)
        if own_test and mutation.is_noticed(name, text, own_test, tests, asked, ""):
            return None
        label = f"{name}:{mutant.number}: '{mutant.new.strip()}' in: {mutant.changed}"
        if asked and mutation.is_noticed(name, text, sources, tests, asked, label):
            return None
        reason = known_reason(name, mutant)
        never = "" if asked else " (no test runs it)"
        print(f"{label}{never}" + (f"\n    known: {reason}" if reason else ""), flush=True)
        return reason is not None

    with concurrent.futures.ThreadPoolExecutor(mutation.jobs) as pool:
        found = list(pool.map(survives, ours))
    counts = len(all_of_it), found.count(True) + len(all_of_it) - len(ours), found.count(False)
    print("{}: done, {} mutants, {} known, {} not".format(name, *counts), flush=True)
    return counts


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("files", nargs="*", metavar="FILE[:LINE[-LINE]]")
    parser.add_argument("-j", "--jobs", type=int, default=1, help="so many mutants at a time")
    parser.add_argument("--skip-known", action="store_true", help="do not run those that have a reason")
    options = parser.parse_intermixed_args()
    if misplaced := misplaced_reasons():
        print("\n".join(misplaced), file=sys.stderr)
        return 2
    names = options.files or sorted(FILES)
    entries = {e["file"]: e for e in json.loads((options.build / "compile_commands.json").read_text())}
    with tempfile.TemporaryDirectory() as temporary:
        mutation = Mutation(options.build, pathlib.Path(temporary), entries, options.jobs)
        counts = [survivors_of(mutation, name, options.skip_known) for name in names]
    total = [sum(c) for c in zip(*counts)]
    print("{} mutants, {} survivors with a reason, {} without".format(*total))
    return 1 if total[2] else 0


if __name__ == "__main__":
    sys.exit(main())
