#include "dupin/io/schema.h"

namespace dupin {
namespace {

// Written by CMake from the files, as literals.
constexpr std::string_view kAssembly =
#include "assembly_schema.inc"
    ;
constexpr std::string_view kCertificate =
#include "certificate_schema.inc"
    ;

}  // namespace

std::string_view assembly_schema() { return kAssembly; }
std::string_view certificate_schema() { return kCertificate; }

}  // namespace dupin
