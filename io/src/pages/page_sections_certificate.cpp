#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "dupin/kernel/decimal.h"
#include "pages/page_sections.h"

namespace dupin::pages {
namespace {

constexpr std::size_t kNearestShown = 100;

class Claims {
 public:
  explicit Claims(const Certificate& certificate)
      : certificate_(certificate), unit_(symbol(certificate.unit)) {}

  PageSection section() {
    for (std::size_t i = 0; i < certificate_.parts.size(); ++i) {
      add_part(certificate_.parts[i].name, certificate_.claims[i]);
    }
    for (std::size_t i = 0; i < certificate_.fillets.size(); ++i) {
      for (const LoopClaims& loop : certificate_.fillet_claims[i]) {
        const std::string& about = certificate_.fillets[i].name;
        add_regular(about, loop.regular);
        add_embedded(about, loop.embedded);
        add_contact(about, loop.contact);
        add_mesh(about, loop.mesh);
      }
    }
    add_clearances();
    std::ranges::stable_sort(rows_, {}, [](const PageRow& row) { return !row.is_finding; });
    PageSection section{"Certificate", "", {"verdict", "claim", "about", ""}};
    for (const auto& [claim, counts] : counts_) {
      section.note += (section.note.empty() ? "" : "; ") + claim + ": " +
                      std::to_string(counts[0]) + " proved, " + std::to_string(counts[1]) +
                      " refuted, " + std::to_string(counts[2]) + " undecided";
    }
    section.note += "." + left_out_;
    section.rows = std::move(rows_);
    return section;
  }

 private:
  void add(const std::string& claim, const std::string& about, Verdict verdict,
           const std::string& detail, std::optional<PagePlace> place = {}) {
    ++counts_[claim].at(std::size_t(verdict));
    if (place) {
      place->is_marked = verdict != Verdict::proved;
    }
    rows_.push_back({{std::string(name(verdict)), claim, about, detail},
                     verdict != Verdict::proved,
                     std::move(place)});
  }

  void add_regular(const std::string& about, const RegularClaim& claim) {
    add("margin", about, claim.verdict, "above " + decimal_at_least(claim.margin));
  }

  void add_embedded(const std::string& about, const EmbeddedClaim& claim) {
    add("embedded", about, claim.verdict, claim.overlap ? "it crosses itself" : "",
        place_of(claim.overlap));
  }

  void add_contact(const std::string& about, const std::optional<ContactClaim>& claim) {
    add("tangent", about, claim ? Verdict::proved : Verdict::undecided,
        claim ? "within " + decimal_at_most(claim->deviation) + " rad" : "");
  }

  void add_mesh(const std::string& about, const std::optional<MeshClaim>& claim) {
    add("mesh error", about, claim ? Verdict::proved : Verdict::undecided,
        claim ? at_most(claim->error_bound, unit_) : "");
  }

  void add_part(const std::string& about, const PartClaims& claims) {
    if (claims.regular) {
      add_regular(about, *claims.regular);
    }
    if (claims.embedded) {
      add_embedded(about, *claims.embedded);
    }
    double angle = -1;
    for (const TangencyClaim& claim : claims.tangency) {
      angle = std::max(angle, claim.deviation.value_or(-1));
    }
    if (angle >= 0) {
      add("tangent", about, Verdict::proved, "within " + decimal_at_most(angle) + " rad");
    }
    add_mesh(about, claims.mesh);
  }

  void add_clearances() {
    std::vector<const ClearanceClaim*> claims;
    for (const ClearanceClaim& claim : certificate_.clearances) {
      claims.push_back(&claim);
    }
    std::ranges::stable_sort(claims, {}, [](const ClearanceClaim* claim) {
      return std::pair(claim->verdict == Verdict::proved && !claim->overlap, claim->distance);
    });
    std::size_t shown = 0;
    for (const ClearanceClaim* claim : claims) {
      if (claim->verdict == Verdict::proved && shown++ >= kNearestShown) {
        ++counts_["clearance"].at(std::size_t(Verdict::proved));
        continue;
      }
      const bool is_joined = certificate_.joined(*claim);
      add("clearance",
          certificate_.parts[claim->first].name + " and " + certificate_.parts[claim->second].name,
          claim->verdict,
          claim->overlap ? "they overlap"
          : is_joined    ? "nothing in common but the joint"
          : claim->distance > 0
              ? "at least " + decimal_at_least(claim->distance) + (unit_.empty() ? "" : " " + unit_)
              : "",
          place_of(claim->overlap));
    }
    if (shown > kNearestShown) {
      left_out_ =
          " " + counted(shown - kNearestShown, "pair") + " further apart are left out below.";
    }
  }

  static std::optional<PagePlace> place_of(const std::optional<Overlap>& overlap) {
    if (!overlap) {
      return std::nullopt;
    }
    return PagePlace{overlap->point};
  }

  const Certificate& certificate_;
  std::string unit_, left_out_;
  std::map<std::string, std::array<std::size_t, 3>> counts_;
  std::vector<PageRow> rows_;
};

}  // namespace

PageSection certificate_section(const Certificate& certificate) {
  return Claims(certificate).section();
}

}  // namespace dupin::pages
