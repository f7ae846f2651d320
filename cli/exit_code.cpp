#include "exit_code.h"

namespace dupin::cli {

ExitCode exit_code(Errc code) {
  switch (code) {
    case Errc::invalid_argument:
    case Errc::not_closed:
    case Errc::not_manifold:
    case Errc::not_oriented:
    case Errc::self_intersecting:
    case Errc::limit_exceeded:
    case Errc::parse_failed:
    case Errc::io_failed:
      return ExitCode::input;
    case Errc::irregular_surface:
    case Errc::infeasible_blend:
    case Errc::boolean_failed:
    case Errc::contact:
    case Errc::unroundable:
    case Errc::cancelled:
      return ExitCode::refused;
    case Errc::internal:
      return ExitCode::internal;
  }
  return ExitCode::internal;
}

}  // namespace dupin::cli
