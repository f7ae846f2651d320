#pragma once

#include <exception>
#include <new>
#include <string>

#include "dupin/kernel/error.h"

namespace dupin::cross_check {

/// Runs `operation`, turning the failures of CGAL's algorithms (violated preconditions, crossing
/// constraints) into Error{boolean_failed}. `what` names the operation for the message.
template <class Operation>
auto guarded(const std::string& what, Operation&& operation) {
  try {
    return operation();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& failure) {
    throw Error(Errc::boolean_failed, what + " failed: " + failure.what());
  }
}

}  // namespace dupin::cross_check
