#include "files/xml_events.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>

#include <expat.h>

#include "dupin/kernel/error.h"

namespace dupin::files {
namespace {

constexpr char kNamespaceEnd = '|';

std::string_view local_name(std::string_view name) {
  return name.substr(name.rfind(kNamespaceEnd) + 1);
}

struct FreeParser {
  void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
};
using Parser = std::unique_ptr<std::remove_pointer_t<XML_Parser>, FreeParser>;

struct State {
  XML_Parser parser = nullptr;
  const XmlEvents* events = nullptr;
  std::exception_ptr failure;
  bool enough = false;
  std::optional<std::string> root_space = {};
  XmlSpaces spaces = {};
};

/// Whether an element is none of the root's namespace, and the user asked to be told so.
bool is_of_other_space(State& state, std::string_view name) {
  const std::size_t end = name.rfind(kNamespaceEnd);
  const std::string_view space = name.substr(0, end == std::string_view::npos ? 0 : end);
  if (!state.root_space) {
    state.root_space = std::string(space);
  }
  return state.events->begin_of_other_space && space != *state.root_space;
}

/// Exceptions must not pass through expat, which is C.
template <typename Action>
void guarded(void* user, const Action& action) {
  State& state = *static_cast<State*>(user);
  if (state.failure || state.enough) {
    return;
  }
  try {
    state.enough = !action(*state.events);
  } catch (...) {
    state.failure = std::current_exception();
  }
  if (state.failure || state.enough) {
    XML_StopParser(state.parser, XML_FALSE);
  }
}

void XMLCALL on_begin(void* user, const char* name, const char** attributes) {
  State& state = *static_cast<State*>(user);
  guarded(user, [&](const XmlEvents& events) {
    if (is_of_other_space(state, name)) {
      events.begin_of_other_space(local_name(name));
      return true;
    }
    return events.begin(local_name(name), XmlAttributes(attributes, state.spaces));
  });
}

void XMLCALL on_end(void* user, const char* name) {
  State& state = *static_cast<State*>(user);
  guarded(user, [&](const XmlEvents& events) {
    if (!is_of_other_space(state, name)) {
      events.end(local_name(name));
    }
    return true;
  });
}

void XMLCALL on_text(void* user, const char* text, int size) {
  guarded(user, [&](const XmlEvents& events) {
    events.text(std::string_view(text, static_cast<std::size_t>(size)));
    return true;
  });
}

void XMLCALL on_space(void* user, const char* prefix, const char* space) {
  State& state = *static_cast<State*>(user);
  guarded(user, [&](const XmlEvents&) {
    if (!state.root_space && prefix != nullptr && space != nullptr) {
      state.spaces.emplace(prefix, space);
    }
    return true;
  });
}

void XMLCALL on_doctype(void* user, const char*, const char*, const char*, int) {
  guarded(user, [](const XmlEvents&) -> bool {
    throw Error(Errc::parse_failed, "found a document type declaration, expected none");
  });
}

}  // namespace

std::optional<std::string_view> XmlAttributes::find(std::string_view name) const {
  for (const char** attribute = raw_; *attribute != nullptr; attribute += 2) {
    if (name == *attribute) {
      return attribute[1];
    }
  }
  return std::nullopt;
}

void read_xml(std::string_view text, const std::string& place, const XmlEvents& events) {
  const Parser parser(XML_ParserCreateNS(nullptr, kNamespaceEnd));
  if (!parser) {
    throw std::bad_alloc();
  }
  State state{parser.get(), &events, {}};
  XML_SetUserData(parser.get(), &state);
  XML_SetElementHandler(parser.get(), on_begin, on_end);
  XML_SetStartNamespaceDeclHandler(parser.get(), on_space);
  if (events.text) {
    XML_SetCharacterDataHandler(parser.get(), on_text);
  }
  XML_SetStartDoctypeDeclHandler(parser.get(), on_doctype);
  constexpr std::size_t kChunk = std::size_t{1} << 20;  // XML_Parse counts in int
  XML_Status status = XML_STATUS_OK;
  for (bool last = false; !last && status == XML_STATUS_OK;) {
    const std::string_view chunk = text.substr(0, kChunk);
    text.remove_prefix(chunk.size());
    last = text.empty();
    status = XML_Parse(parser.get(), chunk.data(), static_cast<int>(chunk.size()), last);
  }
  if (status == XML_STATUS_OK || state.enough) {
    return;
  }
  const std::string where = place + ":" + std::to_string(XML_GetCurrentLineNumber(parser.get()));
  if (!state.failure) {
    throw Error(Errc::parse_failed,
                std::string("found faulty XML (") +
                    XML_ErrorString(XML_GetErrorCode(parser.get())) + "), expected valid XML",
                {}, where);
  }
  try {
    std::rethrow_exception(state.failure);
  } catch (const Error& error) {
    throw Error(error.code(), error.message(), error.part(),
                error.where().empty() ? where : error.where());
  }
}

}  // namespace dupin::files
