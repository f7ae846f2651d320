#pragma once

#include "dupin/blends/certificate.h"

namespace dupin {

/// Checks every proved and every refuted claim again from the certificate's own inputs, by other
/// code than the prover's. Throws Error{invalid_argument} naming the part and claim that does not
/// follow.
void verify(const Certificate& certificate);

}  // namespace dupin
