#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "io/json/forged_certificates.h"

namespace dupin::test {

std::vector<Forgery> forgeries_of_chains() {
  return {{"a hollow mesh nearer than it is",
           [](Certificate& c, const Truth&, Random& random) {
             claims(c, "shell").mesh->error_bound *= between(random, 0, .5);
           }},
          {"a hollow mesh of which a skin is missing, or is one band",
           [](Certificate& c, const Truth&, Random& random) {
             MeshClaim& mesh = *claims(c, "shell").mesh;
             auto& knots = random() % 2 == 0 ? mesh.inner_knots : mesh.knots;
             knots = random() % 2 == 0 ? std::vector<double>() : std::vector<double>{0, 1};
           }},
          {"an inner skin of what has none",
           [](Certificate& c, const Truth&, Random& random) {
             const char* const names[] = {"a", "elbow", "oval", "arm", "ball"};
             claims(c, names[random() % 5]).mesh->inner_knots = {0, 1};
           }},
          {"a mesh of a wall thicker than its tube",
           [](Certificate& c, const Truth&, Random& random) {
             chain(c, "shell").wall = between(random, 1.001, 4);
             claims(c, "shell").regular = RegularClaim{};
             claims(c, "shell").embedded = EmbeddedClaim{};
             claims(c, "shell").mesh->error_bound = 100;
           }},
          {"kneecaps of smooth chains",
           [](Certificate& c, const Truth&, Random& random) {
             const char* const names[] = {"a", "elbow", "shell", "oval"};
             chain(c, names[random() % 4]).joints = Joints::spherical;
           }},
          {"a smooth chain where kneecaps are",
           [](Certificate& c, const Truth&, Random& random) {
             chain(c, "arm").joints = Joints::smooth;
             if (random() % 2 == 0) {
               claims(c, "arm").mesh->kneecaps.reset();
             }
           }},
          {"a kneecap between pieces that end in other balls",
           [](Certificate& c, const Truth&, Random& random) {
             PeVector& ball = std::get<CyclidePiece>(chain(c, "arm").pieces[1]).first;
             (random() % 2 == 0 ? ball.r : ball.m.x()) += between(random, 1e-15, 1);
           }},
          {"kneecaps of triangles that are too large, or of any "
           "number",
           [](Certificate& c, const Truth&, Random& random) {
             auto& segments = claims(c, "arm").mesh->kneecaps->segments;
             switch (random() % 3) {
               case 0:
                 segments.front() = std::uint32_t(random() % 4);
                 break;
               case 1:
                 segments.resize(2 * (random() % 2), 64);
                 break;
               default:
                 segments.front() = 1'000'001 + std::uint32_t(random() % 900'000);
             }
           }},
          {"columns that turn more than the bound has room for",
           [](Certificate& c, const Truth&, Random& random) {
             claims(c, "arm").mesh->kneecaps->turn =
                 (random() % 2 == 0 ? 1 : -1) * between(random, 1, 3);
           }},
          {"what counts as one, and is not in the bound",
           [](Certificate& c, const Truth&, Random& random) {
             claims(c, "arm").mesh->kneecaps->apart =
                 (random() % 2 == 0 ? 1 : -1) * between(random, .2, 3);
           }},
          {"how columns turn in a smooth chain",
           [](Certificate& c, const Truth&, Random& random) {
             const char* const names[] = {"a", "elbow", "shell", "ball"};
             claims(c, names[random() % 4]).mesh->kneecaps.emplace();
           }},
          {"a kneecap further from others than it is",
           [](Certificate& c, const Truth&, Random& random) {
             pair(c, "arm", "dot").distance = between(random, .26, 2);
           }},
          {"a ball in a kneecap, apart from the discs",
           [](Certificate& c, const Truth&, Random& random) {
             auto& ball = std::get<Sphere>(c.parts[part(c, "dot")].shape);
             ball = {Vec3(.65, 599.35, 0), .1};
             separate(c, pair(c, "arm", "dot"), between(random, 1e-9, .1), random);
             for (DiscPairs& leaf : pair(c, "arm", "dot").leaves) {
               leaf.direction = Vec3(1, -1, 0);
             }
             claims(c, "dot").mesh->error_bound = 1;
           }},
          {"kneecaps that cross nothing, for any reason",
           [](Certificate& c, const Truth&, Random& random) {
             claims(c, "arm").embedded->leaves = any_leaves(random, 2, 2, true);
           }},
          {"a joint with a way through a kneecap", [](Certificate& c, const Truth&, Random&) {
             pair(c, "arm", "wrist").leaves = {{{0, 1}, {0, 1}, {}}, {{1, 2}, {0, 1}, {}}};
           }}};
}

}  // namespace dupin::test
