#include "dupin/blends/certify.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <numbers>
#include <optional>
#include <string>

#include <CLI/App.hpp>

#include "commands.h"
#include "document.h"
#include "dupin/blends/canal_fillet.h"
#include "dupin/blends/certificate.h"
#include "dupin/io/certificate_json.h"
#include "dupin/io/sha256.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/printable.h"
#include "exit_code.h"
#include "input.h"
#include "length.h"
#include "output.h"
#include "progress_line.h"
#include "report_text.h"

namespace dupin::cli {
namespace {

struct CertifyArguments {
  std::string file, output;
  SourceArguments source;
  std::optional<double> margin;
  std::size_t most_triangles = kUsualTriangles;
};

std::string unit_of(const Certificate& certificate) {
  return " " + std::string(symbol(certificate.unit));
}

std::string named(const Certificate& certificate, const ClearanceClaim& claim) {
  return certificate.surface_name(claim.first) + " and " + certificate.surface_name(claim.second);
}

/// Where the arcs between the feet of a fillet's balls are shortest, and how long they are.
struct NarrowPlace {
  Vec3 place = Vec3::Zero();
  double width = 0, widest = 0;
};

NarrowPlace narrowest(const CanalFillet& loop) {
  constexpr int kPlaces = 1024;
  const auto arc_at = [&](double t) { return contact_arc(loop.quadrics, ball(loop, t)); };
  const auto width = [&](double t) {
    const ContactArc arc = arc_at(t);
    return arc.radius * arc.angle;
  };
  double step = 2 * std::numbers::pi / kPlaces, least = 0, width_there = width(0), widest = 0;
  const auto look_at = [&](double t) {
    const double here = width(t);
    if (here < width_there) {
      least = t;
      width_there = here;
    }
    return here;
  };
  for (int i = 0; i < kPlaces; ++i) {
    widest = std::max(widest, look_at(i * step));
  }
  for (; step > 1e-12; step /= 2) {
    look_at(least - step);
    look_at(least + step);
  }
  return {arc_at(least).feet[0], width_there, widest};
}

/// Claims about fillets are searched for, and are undecided where the search ends before.
std::string why_undecided(const CanalFillet& loop, const std::string& unit) {
  constexpr double kNarrow = 0.05;  // of the widest
  const std::string limit = ", no proof was found within the work that a certificate may take";
  const NarrowPlace narrow = narrowest(loop);
  return narrow.width < kNarrow * narrow.widest
             ? limit + ": its pipes all but touch at " + place_text(narrow.place) +
                   ", where it is " + number(narrow.width) + unit + " wide"
             : limit;
}

/// Every claim that is not proved, on a line of its own.
void print_findings(std::ostream& out, const Certificate& certificate) {
  const auto print = [&](const std::string& about, std::string_view claim, Verdict verdict) {
    if (verdict != Verdict::proved) {
      out << "  " << name(verdict) << ": " << about << ": " << claim << '\n';
    }
  };
  for (std::size_t i = 0; i < certificate.parts.size(); ++i) {
    const PartClaims& claims = certificate.claims[i];
    if (claims.regular && claims.embedded) {
      print(certificate.parts[i].name, "margin above " + decimal_at_least(claims.regular->margin),
            claims.regular->verdict);
      const auto& overlap = claims.embedded->overlap;
      print(certificate.parts[i].name,
            overlap ? "embedded, crosses itself at " + place_text(overlap->point) : "embedded",
            claims.embedded->verdict);
    }
    print(certificate.parts[i].name, "mesh error",
          claims.mesh ? Verdict::proved : Verdict::undecided);
  }
  for (std::size_t i = 0; i < certificate.fillets.size(); ++i) {
    const CertifiedFillet& fillet = certificate.fillets[i];
    for (std::size_t loop = 0; loop < fillet.loops.size(); ++loop) {
      const LoopClaims& claims = certificate.fillet_claims[i].at(loop);
      std::string why;  // the same for all claims, if any is undecided
      const auto print_claim = [&](const std::string& claim, Verdict verdict) {
        const bool is_open = verdict == Verdict::undecided;
        if (is_open && why.empty()) {
          why = why_undecided(fillet.loops[loop], unit_of(certificate));
        }
        print(fillet.name, claim + (is_open ? why : ""), verdict);
      };
      print_claim("margin above " + decimal_at_least(claims.regular.margin),
                  claims.regular.verdict);
      print_claim("embedded", claims.embedded.verdict);
      print_claim("touches its pipes", claims.contact ? Verdict::proved : Verdict::undecided);
      print_claim("mesh error", claims.mesh ? Verdict::proved : Verdict::undecided);
    }
  }
  for (const ClearanceClaim& claim : certificate.clearances) {
    print(named(certificate, claim),
          certificate.joined(claim) ? "nothing in common but the joint" : "clearance",
          claim.verdict);
  }
  for (const ClearanceClaim& claim : certificate.fillet_clearances) {
    print(named(certificate, claim), "clearance", claim.verdict);
  }
}

/// ", but for 2 not proved": what a bound of the others says nothing of.
std::string but_for(std::size_t open) {
  return open > 0 ? ", but for " + std::to_string(open) + " not proved" : "";
}

/// Of what nothing is proved of, nothing is said by a bound of the others.
std::string mesh_error_text(const Certificate& certificate) {
  double error = 0;
  std::size_t proved = 0, open = 0;
  const auto include = [&](const std::optional<MeshClaim>& mesh) {
    error = std::max(error, mesh ? mesh->error_bound : 0);
    ++(mesh ? proved : open);
  };
  for (const PartClaims& claims : certificate.claims) {
    include(claims.mesh);
  }
  for (const auto& loops : certificate.fillet_claims) {
    for (const LoopClaims& claims : loops) {
      include(claims.mesh);
    }
  }
  if (proved == 0 && open > 0) {
    return "not proved";
  }
  const std::string unit = unit_of(certificate);
  return "at most " + decimal_at_most(error) + unit +
         (error > certificate.tolerance
              ? ", which does not prove that it keeps to the tolerance, " +
                    number(certificate.tolerance) + unit
              : "") +
         but_for(open);
}

std::string contact_text(const Certificate& certificate) {
  ContactClaim widest;
  std::size_t proved = 0, open = 0;
  for (const auto& loops : certificate.fillet_claims) {
    for (const LoopClaims& claims : loops) {
      const ContactClaim claim = claims.contact.value_or(ContactClaim());
      widest.offset = std::max(widest.offset, claim.offset);
      widest.deviation = std::max(widest.deviation, claim.deviation);
      ++(claims.contact ? proved : open);
    }
  }
  if (proved == 0) {
    return "not proved";
  }
  return "within " + decimal_at_most(widest.offset) + unit_of(certificate) + ", tangent within " +
         decimal_at_most(widest.deviation) + " rad" + but_for(open);
}

/// Of what is proved; parts whose margins are not are counted beside it. Empty: none claims one.
std::string margin_text(const Certificate& certificate) {
  const RegularClaim* tightest = nullptr;
  std::string tightest_name;
  std::size_t open = 0;
  const auto include = [&](const RegularClaim& regular, const std::string& name) {
    if (regular.verdict != Verdict::proved) {
      ++open;
    } else if (tightest == nullptr || regular.margin < tightest->margin) {
      tightest = &regular;
      tightest_name = name;
    }
  };
  for (std::size_t i = 0; i < certificate.parts.size(); ++i) {
    if (certificate.claims[i].regular) {
      include(*certificate.claims[i].regular, certificate.parts[i].name);
    }
  }
  for (std::size_t i = 0; i < certificate.fillets.size(); ++i) {
    for (const LoopClaims& claims : certificate.fillet_claims[i]) {
      include(claims.regular, certificate.fillets[i].name);
    }
  }
  if (tightest == nullptr) {
    return open > 0 ? "not proved" : "";
  }
  return "above " + decimal_at_least(tightest->margin) + " (" + tightest_name + ")" + but_for(open);
}

/// Of pairs that keep apart; those of which that is not proved are counted beside it.
std::string clearance_text(const Certificate& certificate) {
  const ClearanceClaim* nearest = nullptr;
  std::size_t open = 0;
  const auto include = [&](const ClearanceClaim& claim, bool is_joined) {
    if (claim.verdict != Verdict::proved) {
      open += is_joined || claim.overlap ? 0 : 1;
    } else if (claim.distance > 0 && (nearest == nullptr || claim.distance < nearest->distance)) {
      nearest = &claim;
    }
  };
  for (const ClearanceClaim& claim : certificate.clearances) {
    include(claim, certificate.joined(claim));
  }
  for (const ClearanceClaim& claim : certificate.fillet_clearances) {
    include(claim, false);
  }
  if (nearest == nullptr) {
    return open > 0 ? "not proved" : "";
  }
  return "at least " + decimal_at_least(nearest->distance) + unit_of(certificate) + " (" +
         named(certificate, *nearest) + ")" + but_for(open);
}

std::size_t overlapping_pairs(const Certificate& certificate) {
  std::size_t overlaps = 0;
  for (const auto* clearances : {&certificate.clearances, &certificate.fillet_clearances}) {
    for (const ClearanceClaim& claim : *clearances) {
      overlaps += claim.overlap ? 1 : 0;
    }
  }
  return overlaps;
}

void print_certificate(std::ostream& out, const Certificate& certificate) {
  const auto print_if_any = [&](const std::string& what, const std::string& text) {
    if (!text.empty()) {
      print_row(out, what, text);
    }
  };
  const std::string unit = unit_of(certificate);
  print_row(out, "parts", std::to_string(certificate.parts.size()));
  if (!certificate.fillets.empty()) {
    print_row(out, "fillets", std::to_string(certificate.fillets.size()));
  }
  print_if_any("smallest margin", margin_text(certificate));
  print_row(out, "mesh error", mesh_error_text(certificate));
  print_row(out, "tolerance", number(certificate.tolerance) + unit);
  const JointFit joints = widest_joint(certificate);
  print_row(out, "joints fit",
            "within " + decimal_at_most(joints.offset) + unit + ", " +
                decimal_at_most(joints.angle) + " rad");
  if (!certificate.fillets.empty()) {
    print_row(out, "fillets touch pipes", contact_text(certificate));
  }
  print_if_any("smallest clearance", clearance_text(certificate));
  if (certificate.apart > 0) {
    print_row(out, "all other clearances",
              "at least " + decimal_at_least(certificate.apart) + unit);
  }
  print_row(out, "overlapping pairs", std::to_string(overlapping_pairs(certificate)));
  print_row(out, "not proved", std::to_string(certificate.findings()));
  print_findings(out, certificate);
}

void print_summary(std::ostream& out, const Certificate& certificate, const CommonOptions& common) {
  if (common.json) {
    out << certificate_summary_json(certificate) << '\n';
  } else if (!common.quiet) {
    print_certificate(out, certificate);
  }
}

ExitCode verdict_on(const Certificate& certificate) {
  return certificate.findings() == 0 ? ExitCode::ok : ExitCode::findings;
}

ExitCode run_certify(const CertifyArguments& arguments, const CommonOptions& common) {
  if (arguments.margin && !(*arguments.margin >= 0 && *arguments.margin < 1)) {
    throw UsageError("--margin takes a number of at least 0 and less than 1");
  }
  const Input input = read_input(arguments.file);
  Assembly assembly = read_document(input, arguments.source).assembly;
  assembly.tolerance =
      document_length("--tolerance", assembly.unit, common.tolerance, assembly.tolerance);
  std::optional<ProgressLine> line(common.quiet);
  Certificate certificate = certify(assembly, {.margin = arguments.margin,
                                               .most_triangles = arguments.most_triangles,
                                               .progress = line->callback()});
  line.reset();
  certificate.document = printable(certificate.document);  // a name, which has no controls
  certificate.document_sha256 = sha256(input.bytes);
  write_text(arguments.output, certificate_json(certificate));
  print_summary(report_stream(arguments.output), certificate, common);
  return verdict_on(certificate);
}

struct VerifyArguments {
  std::string file, document;
  SourceArguments source;
};

ExitCode run_verify(const VerifyArguments& arguments, const CommonOptions& common) {
  refuse_tolerance("verify", common);
  if (arguments.document.empty() && is_given(arguments.source)) {
    throw UsageError(
        "--radius, --unit, --snap, --bridge, --bore, --schedule, --fillet, --keep-going and "
        "--strict say how FILE is read, and none is given");
  }
  const Input input = read_input(arguments.file);
  Certificate certificate = parse_certificate(input.bytes, input.name);
  if (!arguments.document.empty()) {
    const Input about = read_input(arguments.document);
    require_about(certificate, about.bytes, read_document(about, arguments.source).assembly);
    certificate.document = printable(about.name);
  }
  {
    ProgressLine line(common.quiet);
    tell(line.callback(), "verify");
    verify(certificate, input.name);
  }
  print_summary(std::cout, certificate, common);
  return verdict_on(certificate);
}

}  // namespace

void add_certify(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("certify", "Prove that the smooth parts of an assembly are sound");
  const auto arguments = std::make_shared<CertifyArguments>();
  command
      ->add_option("FILE", arguments->file,
                   "assembly document, graph or piping file; - for standard input")
      ->type_name("")
      ->required();
  command->add_option("-o,--output", arguments->output, "certificate; - for standard output")
      ->type_name("OUT")
      ->required();
  command
      ->add_option("--margin", arguments->margin,
                   "Prove 1 - kappa R > NUMBER, instead of nearly the largest that holds")
      ->type_name("NUMBER");
  add_triangles_option(*command, arguments->most_triangles);
  add_source_options(*command, arguments->source);
  command->footer(
      "Exit code 1 means that a claim is refuted or undecided.\n\n"
      "Examples:\n"
      "  dupin certify examples/reducer.json -o reducer.cert.json\n"
      "  dupin verify reducer.cert.json");
  command->callback([arguments, &action] {
    action = [arguments](const CommonOptions& common) { return run_certify(*arguments, common); };
  });
}

void add_verify(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("verify", "Check every claim of a certificate again, independently");
  const auto arguments = std::make_shared<VerifyArguments>();
  command->add_option("CERTIFICATE", arguments->file, "what certify wrote; - for standard input")
      ->type_name("")
      ->required();
  command
      ->add_option("FILE", arguments->document,
                   "the document, graph or piping file it must be about")
      ->type_name("");
  add_source_options(*command, arguments->source);
  command->footer(
      "Exit code 1 means that it holds, but a claim is refuted or undecided; 3 that it was "
      "changed\n"
      "or that a claim does not follow.\n\n"
      "Examples:\n"
      "  dupin verify reducer.cert.json examples/reducer.json");
  command->callback([arguments, &action] {
    action = [arguments](const CommonOptions& common) { return run_verify(*arguments, common); };
  });
}

}  // namespace dupin::cli
