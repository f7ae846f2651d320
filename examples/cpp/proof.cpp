// A certificate: proofs about a document's smooth surfaces, checked again by code that shares
// nothing with the prover.

#include <iostream>

#include "dupin/blends/certify.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/certificate_json.h"

int main() {
  const dupin::Assembly assembly = dupin::read_assembly("examples/reducer.json");
  const dupin::Certificate certificate = dupin::certify(assembly, {.margin = 0.08});
  std::cout << certificate.findings() << " claims not proved\n";

  // What leaves the program is text; whoever reads it need not trust the prover.
  std::string text = dupin::certificate_json(certificate);
  dupin::verify(dupin::parse_certificate(text));
  std::cout << "verified\n";

  // No byte of it can be changed unnoticed.
  text.replace(text.find("0.05"), 4, "0.06");
  try {
    dupin::verify(dupin::parse_certificate(text));
  } catch (const dupin::Error& error) {
    std::cout << dupin::name(error.code()) << ": " << error.message() << '\n';
  }

  // A margin that the blend does not have is refuted, not lost.
  const dupin::Certificate refuted = dupin::certify(assembly, {.margin = 0.5});
  for (std::size_t i = 0; i < refuted.parts.size(); ++i) {
    if (const auto& regular = refuted.claims[i].regular) {
      std::cout << refuted.parts[i].name << ": margin 0.5 " << dupin::name(regular->verdict)
                << '\n';
    }
  }
}
