#include "io/json/forged_certificates.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <sstream>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/certificate.h"
#include "dupin/blends/certify.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/certificate_json.h"
#include "dupin/io/sha256.h"
#include "dupin/kernel/error.h"

namespace dupin::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Of one of both fillets, and what is claimed of it.
CanalFillet& loop(Certificate& c, Random& random) {
  auto& loops = c.fillets[random() % 2].loops;
  return loops[random() % loops.size()];
}

LoopClaims& loop_claims(Certificate& c, Random& random) {
  auto& loops = c.fillet_claims[random() % 2];
  return loops[random() % loops.size()];
}

// Of those about fillets that are proved by a distance, or by corners.
ClearanceClaim& fillet_clearance(Certificate& c, bool by_corners, Random& random) {
  std::vector<ClearanceClaim*> found;
  for (ClearanceClaim& claim : c.fillet_clearances) {
    if (by_corners ? claim.corner > 0 : claim.distance > 0) {
      found.push_back(&claim);
    }
  }
  return *found.at(random() % found.size());
}

double& ball_radius(CanalFillet& loop) { return std::get<RollingThrough>(loop.motion).radius; }

RingedSurface& tube(Certificate& c, const std::string& name) {
  return std::get<RingedSurface>(chain(c, name).pieces.front());
}

void embed(Certificate& c, const std::string& name, Random& random) {
  const double pieces = length(c.parts[part(c, name)]);
  RegularClaim regular{Verdict::proved, between(random, 0, .9), {}, {}};
  const int cuts = 1 << random() % 8;
  for (int i = 0; i < int(pieces) * cuts; ++i) {
    regular.leaves.push_back({double(i) / cuts, double(i + 1) / cuts});
  }
  if (random() % 2 == 0) {
    claims(c, name).regular = regular;
  }
  claims(c, name).embedded =
      EmbeddedClaim{Verdict::proved, any_leaves(random, pieces, pieces, true), {}};
}

// The same loop, as a rational curve with weights that exact numbers hold and doubles do not.
void make_rational(Certificate& c, const std::vector<double>& weights) {
  RingedSurface& loop = tube(c, "loop");
  const auto& hermite = std::get<HermiteSpine>(loop.spine);
  loop.spine = BezierSpine{{hermite.from, hermite.from + hermite.start_velocity / 3,
                            hermite.to - hermite.end_velocity / 3, hermite.to},
                           weights};
}

void set_radius(Certificate& c, const std::string& name, const RadiusLaw& law) {
  tube(c, name).radius = law;
}

}  // namespace

Truth truth(Random& random) {
  const double r = between(random, .4, 1), rb = between(random, .4, 1),
               bend = between(random, 2, 4);
  const double height = between(random, -.7, .7), oval = between(random, 1.2, 2);
  const double size = between(random, .8, 1.3);
  std::ostringstream text;
  text.precision(17);
  text << R"({"units": "mm", "tolerance": 0.2, "parts": [
  {"name": "a", "pipe": {"from": [-5, 0, 0], "to": [5, 0, 0], "radius": )"
       << r << R"(}},
  {"name": "b", "pipe": {"from": [0, -5, )"
       << height << "], \"to\": [0, 5, " << height << R"(], "radius": )" << rb << R"(}},
  {"name": "ball", "sphere": {"center": [3, 0, 6], "radius": 2}},
  {"name": "elbow", "elbow": {"from": [0, 100, 0], "direction": [1, 0, 0], "radius": 1, "bend_radius": )"
       << bend << R"(, "angle": 90, "toward": [0, 1, 0]}},
  {"name": "on", "pipe": {"from": "elbow.end", "length": 3}},
  {"name": "oval", "pipe": {"from": [0, 200, 0], "to": [9, 200, 0], "semi_axes": [)"
       << oval << R"(, 1], "axis": [0, 0, 1]}},
  {"name": "in", "pipe": {"from": [0, 300, 0], "direction": [1, 0, 0], "length": 1, "radius": 1}},
  {"name": "out", "pipe": {"from": [)"
       << 4 * size << ", " << 300 - 4 * size
       << R"(, 0], "direction": [0, -1, 0], "length": 1, "radius": 1}},
  {"name": "loop", "cyclic_blend": {"from": "in.end", "to": "out.start", "radius_law": "R1", "k": )"
       << 60 * size << ", \"l\": " << 60 * size << R"(}},
  {"name": "shell", "cyclide_chain": {"wall": )"
       << between(random, .3, .6) << R"(, "direction": [0, 1, 0], "slope": 0,
   "spheres": [[4, 500, 0, 1], [2.83, 502.83, 0, 1], [0, 504, 0, 1]]}},
  {"name": "arm", "cyclide_chain": {"joints": "kneecaps", "spheres":
   [[-4, 600, 0, 1], [-2, 600, 0, 1], [0, 600, 0, 1], [0, 602, 0, 1], [0, 604, 0, 1]]}},
  {"name": "wrist", "pipe": {"from": "arm.end", "length": 2}},
  {"name": "dot", "sphere": {"center": [1.06, 598.94, 0], "radius": 0.25}},
  {"name": "run", "pipe": {"from": [-20, 400, 0], "to": [20, 400, 0], "radius": 2}},
  {"name": "equal", "pipe": {"from": [-9, 400, 0], "to": [-9, 400, 9], "radius": 2}},
  {"name": "through", "pipe": {"from": [9, 391, 0.5], "to": [9, 409, 0.5], "radius": )"
       << r << R"(}},
  {"name": "throat", "fillet": {"between": ["run", "equal"], "radius": )"
       << between(random, .3, .6) << R"(}},
  {"name": "throats", "fillet": {"between": ["through", "run"], "radius": )"
       << between(random, .1, .4) << R"(}},
  {"name": "beam", "pipe": {"from": [-9, 700, 0], "to": [9, 700, 0], "radius": 2}},
  {"name": "over", "pipe": {"from": [0, 700, 0], "to": [0, 700, 9], "radius": 2}},
  {"name": "under", "pipe": {"from": [0, 700, 0], "to": [0, 700, -9], "radius": 2}},
  {"name": "throat-over", "fillet": {"between": ["beam", "over"], "radius": )"
       << between(random, .3, .6) << R"(}},
  {"name": "throat-under", "fillet": {"between": ["beam", "under"], "radius": )"
       << between(random, .3, .6) << R"(}}]})";
  Truth result{text.str(), {}, 1 - 1 / bend};
  result.honest = certify(parse_assembly(result.document, "truth.json"));
  result.honest.document_sha256 = sha256(result.document);
  return result;
}

namespace {

std::vector<Forgery> forgeries_of_pipes() {
  return {
      {"a pipe and a ball further apart than they are",
       [](Certificate& c, const Truth&, Random& random) {
         const double r = std::get<ConstantRadius>(tube(c, "a").radius).radius;
         pair(c, "a", "ball").distance = (4 - r) * between(random, 1 + 1e-12, 3);
       }},
      {"crossing pipes apart",
       [](Certificate& c, const Truth&, Random& random) {
         separate(c, pair(c, "a", "b"), between(random, 1e-9, 10), random);
       }},
      {"crossing pipes apart by a number of any size",
       [](Certificate& c, const Truth&, Random& random) {
         separate(c, pair(c, "a", "b"), std::abs(hostile(random)) + 5e-324, random);
       }},
      {"crossing pipes apart without a claim, by boxes along any axes",
       [](Certificate& c, const Truth&, Random& random) {
         const ClearanceClaim& crossing = pair(c, "a", "b");
         std::erase_if(c.clearances, [&, first = crossing.first,
                                      second = crossing.second](const ClearanceClaim& claim) {
           return claim.first == first && claim.second == second;
         });
         c.apart = std::abs(hostile(random)) + 5e-324;
         c.axes.emplace();
         for (Vec3& axis : *c.axes) {
           axis = Vec3(hostile(random), between(random, -1, 1), hostile(random));
         }
       }},
      {"a distance beside the point that both have",
       [](Certificate& c, const Truth&, Random& random) {
         pair(c, "a", "b").distance = between(random, 1e-300, 1);
       }},
      {"a distance that is undecided",
       [](Certificate& c, const Truth&, Random& random) {
         pair(c, "a", "b") = {part(c, "a"),           part(c, "b"), Verdict::undecided,
                              between(random, .1, 9), {},           {}};
       }},
      {"a point of parts that are apart",
       [](Certificate& c, const Truth&, Random& random) {
         ClearanceClaim& claim = pair(c, "a", "ball");
         claim.distance = 0;
         claim.leaves.clear();
         const double t = std::ldexp(double(random() % 1000), -10);
         const ParameterInterval ends[] = {{0, 0}, {1, 1}, {t, t + 0x1p-9}, {0, 1}, {t, t}};
         claim.overlap =
             Overlap{Vec3(3, 0, between(random, .5, 5)), ends[random() % 5], ends[random() % 5]};
       }},
      {"an elbow that bends less tightly than it does",
       [](Certificate& c, const Truth& truth, Random& random) {
         claims(c, "elbow").regular->margin = between(random, truth.bend_margin + 1e-12, 1);
       }},
      {"an elbow that folds",
       [](Certificate& c, const Truth& truth, Random& random) {
         claims(c, "elbow").regular = RegularClaim{
             Verdict::refuted, between(random, 0, truth.bend_margin - 1e-9), {}, {0, 1}};
         claims(c, "elbow").embedded = EmbeddedClaim{};
       }},
      {"a margin of nothing",
       [](Certificate& c, const Truth&, Random& random) {
         claims(c, "elbow").regular =
             RegularClaim{Verdict::undecided, random() % 2 == 0 ? 1 : hostile(random) + 2, {}, {}};
         claims(c, "elbow").embedded = EmbeddedClaim{};
       }},
      {"a loop that does not cross itself",
       [](Certificate& c, const Truth&, Random& random) { embed(c, "loop", random); }},
      {"a loop of tiny weights",
       [](Certificate& c, const Truth&, Random& random) {
         const double weight = std::ldexp(1, -int(random() % 1074));
         make_rational(c, {weight, weight, weight, weight});
         embed(c, "loop", random);
       }},
      {"a loop of weights in any ratio",
       [](Certificate& c, const Truth&, Random& random) {
         const double weight = std::ldexp(1, int(random() % 99));
         make_rational(c, {weight, 1 / weight, 1 / weight, weight});
         for (Vec3& p : std::get<BezierSpine>(tube(c, "loop").spine).points) {
           p *= std::abs(hostile(random));
         }
         embed(c, "loop", random);
         c.claims[part(c, "loop")].regular->verdict = Verdict::proved;
       }},
      {"a pipe of overflowing points, far from the one that it lies in",
       [](Certificate& c, const Truth&, Random& random) {
         const double far = random() % 2 == 0 ? 1e308 : 1.7e308;
         tube(c, "a").spine = BezierSpine{{{-far, 0, 0}, {far, 0, 0}, {-far, 0, 0}, {5, 0, 0}}, {}};
         separate(c, pair(c, "a", "b"), 1000, random);
       }},
      {"a pipe of negative radius",
       [](Certificate& c, const Truth&, Random& random) {
         const double r = -between(random, 1e-9, 3);
         const RadiusLaw laws[] = {ConstantRadius{r}, LinearRadius{r, r}, CubicRadius{r, r},
                                   CyclideRadius{r, r}, BezierRadius{{r, r, r}}};
         set_radius(c, "a", laws[random() % 5]);
         claims(c, "a").regular = RegularClaim{};
         claims(c, "a").embedded = EmbeddedClaim{};
         pair(c, "a", "ball").distance = 4 + std::abs(r) / 2;
       }},
      {"a mesh nearer than its sagitta",
       [](Certificate& c, const Truth&, Random& random) {
         MeshClaim& mesh = *claims(c, "a").mesh;
         const double r = std::get<ConstantRadius>(tube(c, "a").radius).radius;
         mesh.error_bound = r * (1 - std::cos(kPi / mesh.segments)) * between(random, 0, 1 - 1e-9);
       }},
      {"a mesh on a grid that takes away",
       [](Certificate& c, const Truth&, Random& random) {
         const char* const names[] = {"a", "ball", "elbow"};
         MeshClaim& mesh = *claims(c, names[random() % 3]).mesh;
         mesh.grid = -between(random, .1, 1e9);
         mesh.error_bound = 1e-9;
       }},
      {"a mesh of fewer segments",
       [](Certificate& c, const Truth&, Random& random) {
         const char* const names[] = {"a", "ball"};
         MeshClaim& mesh = *claims(c, names[random() % 2]).mesh;
         mesh.segments = mesh.segments / 2;
       }},
      {"a mesh of too many segments",
       [](Certificate& c, const Truth&, Random& random) {
         const char* const names[] = {"a", "ball", "elbow"};
         claims(c, names[random() % 3]).mesh->segments =
             1'000'001 + std::uint32_t(random() % 900'000);
       }},
      {"a mesh whose axes are turned for nothing",
       [](Certificate& c, const Truth&, Random& random) {
         MeshClaim& mesh = *claims(c, "oval").mesh;
         mesh.axes = (random() % 2 == 0 ? 1 : -1) * between(random, .2, 3);
       }},
      {"a mesh with axes of circles",
       [](Certificate& c, const Truth&, Random& random) {
         const char* const names[] = {"a", "ball", "elbow"};
         claims(c, names[random() % 3]).mesh->axes = between(random, 1e-12, 1e-9);
       }},
      {"an ellipse that turns unsaid",
       [](Certificate& c, const Truth&, Random& random) {
         auto& oval = std::get<EllipticTube>(chain(c, "oval").pieces.front());
         const Vec3 normal = oval.end.normal;
         Vec3& axis = oval.end.ellipse->axis;
         axis = (Eigen::AngleAxisd(between(random, .3, 2.8), normal) * axis).normalized();
         claims(c, "oval").tangency.back().offset = 100;
       }},
      {"a bent mesh in one band",
       [](Certificate& c, const Truth&, Random&) {
         claims(c, "elbow").mesh->knots = {0, 1};
       }},
      {"an elliptic pipe judged by its rings",
       [](Certificate& c, const Truth&, Random& random) {
         auto& oval = std::get<EllipticTube>(chain(c, "oval").pieces.front());
         const double more = between(random, 1.01, 2);
         oval.first = LinearRadius{oval.start.radius * more, oval.start.radius / more};
         oval.second = LinearRadius{1 / more, more};
         for (TangencyClaim& claim : claims(c, "oval").tangency) {
           claim.offset = claim.deviation.emplace(100);
         }
         c.tolerance = 1e9;
       }},
      {"a wall of what has none",
       [](Certificate& c, const Truth&, Random& random) {
         const char* const names[] = {"a", "elbow", "oval", "loop"};
         chain(c, names[random() % 4]).wall = between(random, -4, 4);
       }},
      {"a pipe that closes",
       [](Certificate& c, const Truth&, Random& random) {
         const char* const names[] = {"a", "elbow", "loop"};
         chain(c, names[random() % 3]).closed = true;
       }},
      {"parts apart that are joined",
       [](Certificate& c, const Truth&, Random& random) {
         c.parts[part(c, "elbow")].joined[1].reset();
         c.parts[part(c, "on")].joined[0].reset();
         separate(c, pair(c, "elbow", "on"), between(random, 1e-12, 1), random);
       }},
      {"a distance of a shape that nothing is known of",
       [](Certificate& c, const Truth&, Random& random) {
         Chain unknown;
         unknown.joints = Joints::spherical;
         c.parts[part(c, "a")].shape = unknown;
         claims(c, "a") = {RegularClaim{}, EmbeddedClaim{}, {}, {}};
         for (ClearanceClaim& claim : c.clearances) {
           if (c.parts[claim.first].name == "a") {
             claim = {claim.first, claim.second, Verdict::undecided, 0, {}, {}};
           }
         }
         ClearanceClaim& claim = pair(c, "a", random() % 2 == 0 ? "ball" : "elbow");
         claim.verdict = Verdict::proved;
         claim.distance = between(random, 200, 1000);  // further than the pipe is
       }},
      {"parts that are apart without a claim of their own",
       [](Certificate& c, const Truth&, Random& random) {
         c.apart = std::max(std::abs(hostile(random)), between(random, 1, 3));
         std::erase_if(c.clearances, [&](const ClearanceClaim& claim) {
           return c.parts[claim.first].name == "a" && c.parts[claim.second].name == "b";
         });
       }},
      {"crossing pipes that are joined",
       [](Certificate& c, const Truth&, Random& random) {
         const End ends[] = {End::start, End::end};
         c.parts[part(c, "a")].joined[random() % 2] = EndIndex{part(c, "b"), ends[random() % 2]};
         separate(c, pair(c, "a", "b"), 0, random);
       }},
      {"a ring that is joined to itself",
       [](Certificate& c, const Truth&, Random& random) {
         const std::size_t end = random() % 2;
         const std::uint32_t own = part(c, "b");
         c.parts[own].joined[end] = EndIndex{own, end == 0 ? End::start : End::end};
       }},
      {"a joint of which one side knows nothing",
       [](Certificate& c, const Truth&, Random& random) {
         (random() % 2 == 0 ? c.parts[part(c, "elbow")].joined[1]
                            : c.parts[part(c, "on")].joined[0])
             .reset();
       }},
      {"a curve of a high degree",
       [](Certificate& c, const Truth&, Random& random) {
         BezierSpine spine;
         for (std::size_t i = 0; i < 14 + random() % 150; ++i) {
           spine.points.emplace_back(-5 + double(i), std::sin(double(i)), 0);
         }
         tube(c, "a").spine = spine;
       }},
      {"claims about a ball",
       [](Certificate& c, const Truth&, Random& random) {
         claims(c, "ball").regular =
             RegularClaim{Verdict::proved, between(random, 0, .99), {{0, 1}}, {}};
         claims(c, "ball").embedded = EmbeddedClaim{Verdict::proved, {{{0, 1}, {0, 1}, {}}}, {}};
       }},
      {"rings that look another way",
       [](Certificate& c, const Truth&, Random& random) {
         tube(c, "a").start.normal =
             Vec3(-1, between(random, .001, 1), between(random, -1, 1)).normalized();
       }},
      {"rings of no length",
       [](Certificate& c, const Truth&, Random& random) {
         tube(c, "a").start.normal *= hostile(random) + .5;
       }},
      {"another name on the next line",
       [](Certificate& c, const Truth&, Random&) {
         c.parts[part(c, "a")].name = "a\nnot proved           0";
       }},
      {"a fillet further from folding than it is",
       [](Certificate& c, const Truth&, Random& random) {
         LoopClaims& claims = loop_claims(c, random);
         // Within a seventh of what is true.
         claims.regular.margin += (1 - claims.regular.margin) * between(random, .95, 1);
       }},
      {"a fillet regular but for some of it",
       [](Certificate& c, const Truth&, Random& random) {
         auto& leaves = loop_claims(c, random).regular.leaves;
         leaves.erase(leaves.begin() + std::ptrdiff_t(random() % leaves.size()));
       }},
      {"a fillet of other balls, which do not touch",
       [](Certificate& c, const Truth&, Random& random) {
         ball_radius(loop(c, random)) *= between(random, 1.0000001, 1.5);
       }},
      {"a fillet of balls of any number",
       [](Certificate& c, const Truth&, Random& random) {
         auto& motion = std::get<RollingThrough>(loop(c, random).motion);
         double* const numbers[] = {&motion.cosine, &motion.sine,  &motion.distance, &motion.height,
                                    &motion.below,  &motion.above, &motion.radius};
         double& changed = *numbers[random() % std::size(numbers)];
         const double before = changed;
         while (std::abs(changed - before) < 1e-6) {
           changed = hostile(random);
         }
       }},
      {"a fillet nearer to its pipes than it is",
       [](Certificate& c, const Truth&, Random& random) {
         ContactClaim& contact = *loop_claims(c, random).contact;
         (random() % 2 == 0 ? contact.offset : contact.deviation) =
             random() % 2 == 0 ? 0 : -std::abs(hostile(random)) - 1e-300;
       }},
      {"a fillet between other pipes",
       [](Certificate& c, const Truth&, Random& random) {
         const char* const names[] = {"a", "b", "ball", "elbow", "in", "equal"};
         c.fillets[1].between.at(random() % 2) = part(c, names[random() % 6]);
       }},
      {"a fillet that does not meet itself, for any reason",
       [](Certificate& c, const Truth&, Random& random) {
         LoopClaims& claims = loop_claims(c, random);
         claims.embedded.leaves = any_leaves(random, 2, 2, true);
         claims.embedded.leaves.front().direction = any_direction(random);
       }},
      {"a fillet's mesh nearer than its chords",
       [](Certificate& c, const Truth&, Random& random) {
         MeshClaim& mesh = *loop_claims(c, random).mesh;
         if (random() % 2 == 0) {
           mesh.error_bound *= between(random, 0, .2);
         } else {
           mesh.knots = {0, 1, 2};
         }
       }},
      {"claims of no fillet",
       [](Certificate& c, const Truth&, Random& random) {
         if (random() % 2 == 0) {
           c.fillet_claims[random() % 2].clear();
         } else {
           c.fillet_claims.pop_back();
         }
       }},
      {"a fillet further from others than it is",
       [](Certificate& c, const Truth&, Random& random) {
         // At least nine tenths of what is true.
         fillet_clearance(c, false, random).distance *= between(random, 1.2, 3);
       }},
      {"corners nearer than they are",
       [](Certificate& c, const Truth&, Random& random) {
         fillet_clearance(c, true, random).corner *= between(random, -1, .99);
       }},
      {"corners that are one, but for more than the tolerance",
       [](Certificate& c, const Truth&, Random& random) {
         fillet_clearance(c, true, random).corner = c.tolerance * between(random, 1.01, 9);
       }},
      {"a distance of what meets in corners",
       [](Certificate& c, const Truth&, Random& random) {
         ClearanceClaim& claim = fillet_clearance(c, true, random);
         claim.distance = random() % 2 == 0 ? claim.corner : between(random, 1e-15, 1);
         claim.corner = random() % 2 == 0 ? 0 : claim.corner;
       }},
      {"corners of what is apart, of pipes, and of nothing",
       [](Certificate& c, const Truth&, Random& random) {
         ClearanceClaim& claim = random() % 2 == 0 ? fillet_clearance(c, false, random)
                                                   : c.clearances[random() % c.clearances.size()];
         claim.corner = between(random, 1e-15, .1);
       }},
      {"what meets in corners, on the wrong side of them",
       [](Certificate& c, const Truth&, Random& random) {
         for (DiscPairs& leaf : fillet_clearance(c, true, random).leaves) {
           leaf.direction = random() % 2 == 0 ? any_direction(random) : Vec3(-*leaf.direction);
         }
       }},
      {"a fillet apart from others for any reason",
       [](Certificate& c, const Truth&, Random& random) {
         ClearanceClaim& claim = c.fillet_clearances[random() % c.fillet_clearances.size()];
         const auto length_of = [&](std::uint32_t surface) {
           return surface < c.parts.size() ? length(c.parts[surface]) : 2;
         };
         claim.leaves = any_leaves(random, length_of(claim.first), length_of(claim.second), false);
         claim.leaves.front().direction = any_direction(random);
       }},
      {"a point of a fillet in a part that is far from it",
       [](Certificate& c, const Truth&, Random& random) {
         const std::uint32_t far = part(c, random() % 2 == 0 ? "ball" : "a");
         ClearanceClaim& claim =
             *std::ranges::find(c.fillet_clearances, far, &ClearanceClaim::first);
         const double t = std::ldexp(double(random() % 2000), -10);
         claim.distance = 0;
         claim.leaves.clear();
         claim.overlap = Overlap{Vec3(3, 0, between(random, -.3, 6)),
                                 {0.25, 0.875},
                                 {t, random() % 2 == 0 ? t : t + 0x1p-9}};
       }},
      {"loops that are apart and have a corner in common",
       [](Certificate& c, const Truth&, Random& random) {
         fillet_clearance(c, false, random).distance = 0;
       }},
      {"a fillet that is near to nothing",
       [](Certificate& c, const Truth&, Random& random) {
         auto& claims = c.fillet_clearances;
         const auto at = claims.begin() + std::ptrdiff_t(random() % claims.size());
         if (random() % 2 == 0) {
           claims.erase(at);
         } else {
           std::swap(*at, *(at == claims.begin() ? at + 1 : at - 1));
         }
       }},
      {"a fillet that has the name of a part",
       [](Certificate& c, const Truth&, Random&) { c.fillets[0].name = "run"; }},
      {"the fillet of another document",
       [](Certificate& c, const Truth&, Random&) { c.fillets[0].buried[0][0] ^= true; }, true},
      {"the tolerance of another document",
       [](Certificate& c, const Truth&, Random& random) {
         c.tolerance *= between(random, 1.01, 9);
       },
       true},
      {"balls that do not touch, of whose contact nothing is said",
       [](Certificate& c, const Truth&, Random& random) {
         const std::size_t fillet = random() % c.fillets.size();
         for (std::size_t k = 0; k < c.fillets[fillet].loops.size(); ++k) {
           ball_radius(c.fillets[fillet].loops[k]) *= between(random, 1.0000001, 1.5);
           c.fillet_claims[fillet][k].contact.reset();
         }
       },
       true},
      {"the parts of another document",
       [](Certificate& c, const Truth&, Random& random) {
         double& y = std::get<Sphere>(c.parts[part(c, "ball")].shape).center.z();
         y = std::nextafter(y, random() % 2 == 0 ? 0 : 9);
       },
       true},
      {"another name", [](Certificate& c, const Truth&, Random&) { c.parts[0].name = "another"; },
       true},
      {"another unit", [](Certificate& c, const Truth&, Random&) { c.unit = Unit::inch; }, true}};
}

}  // namespace

const std::vector<Forgery>& forgeries() {
  static const std::vector<Forgery> all = [] {
    std::vector<Forgery> both = forgeries_of_pipes();
    const std::vector<Forgery> more = forgeries_of_chains();
    both.insert(both.end(), more.begin(), more.end());
    return both;
  }();
  return all;
}

void expect_none_believed(std::uint64_t seed, int count) {
  using Clock = std::chrono::steady_clock;
  constexpr int kOfOneTruth = 100;
  Random random(seed);
  Truth known;
  for (int i = 0; i < count; ++i) {
    if (i % kOfOneTruth == 0) {
      known = truth(random);
      const Certificate read = parse_certificate(certificate_json(known.honest));
      ASSERT_NO_THROW(verify(read));
      ASSERT_NO_THROW(require_about(read, known.document, "truth.json"));
    }
    const Forgery& forgery = forgeries()[std::size_t(i) % forgeries().size()];
    Certificate forged = known.honest;
    forgery.tell(forged, known, random);
    const auto before = Clock::now();
    try {
      const Certificate read = parse_certificate(certificate_json(forged));
      if (forgery.is_about_another) {
        require_about(read, known.document, "truth.json");
      } else {
        verify(read);
      }
      ADD_FAILURE() << i << ": believed: " << forgery.way;
    } catch (const Error& error) {
      EXPECT_TRUE(error.code() == Errc::invalid_argument || error.code() == Errc::parse_failed ||
                  error.code() == Errc::limit_exceeded)
          << forgery.way << ": " << error.what();
    }
    EXPECT_LT(std::chrono::duration<double>(Clock::now() - before).count(), 10)
        << i << ": " << forgery.way;
  }
}

}  // namespace dupin::test
