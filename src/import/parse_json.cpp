// SPDX-License-Identifier: MIT
#include "import/parse_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "freshet/error.h"
#include "import/json_places.h"

namespace freshet {
namespace {

/// Remedies for syntax errors, by a part of the parser's message. The first that fits counts.
constexpr const char* json_remedies[][2] = {
    {"invalid BOM", "save the file as UTF-8"},
    {"ill-formed UTF-8", "save the file as UTF-8"},
    {"missing closing quote", "close the quotes on the same line"},
    {"control character", "close the quotes on the same line"},
    {"forbidden character after backslash", "write \\\\ for a backslash, or / in paths"},
    {"unexpected end of input", "the file ends too early; close its braces and brackets"},
    {"expected end of input", "remove what follows the last brace"},
    {"invalid number", "write numbers like 0.5, 2 or 1e-3"},
    {"unexpected '}'; expected string", "remove the comma before the brace"},
    {"unexpected '}'", "remove the comma before the brace, or write a value"},
    {"unexpected ']'", "remove the comma before the bracket"},
    {"expected ':'", "write \"KEY\": VALUE"},
    {"while parsing object key - invalid literal", "write keys in quotes: \"key\""},
    {"while parsing object - unexpected", "write a comma between two keys"},
    {"while parsing array - unexpected", "write a comma between two values"},
    {"invalid literal",
     "words need quotes, and true and false small letters; JSON has no comments"},
    {"object key", "write keys in quotes: \"key\""}};

/// The part of the parser's message after the place.
std::string reason_of(const std::string& message) {
  const auto from = message.find(": ");
  std::string reason = from == std::string::npos ? message : message.substr(from + 2);
  const std::string known = "syntax error ";
  if (reason.starts_with(known)) reason = reason.substr(known.size());
  for (std::size_t k = 0; k < reason.size(); ++k)  // it quotes bytes of the file
    if (const auto c = static_cast<unsigned char>(reason[k]); c < ' ' || c >= 0x7f)
      reason[k] = c < ' ' ? ' ' : '?';
  return reason;
}

std::string remedy_of(const std::string& reason) {
  for (const auto& [symptom, remedy] : json_remedies)
    if (reason.find(symptom) != std::string::npos) return std::string("; ") + remedy;
  return "";
}

}  // namespace

nlohmann::json parse_json(const std::string& json, const std::string& file) {
  if (depth_of_json(json) > deepest_json)
    throw Error(Error::Kind::scene, file,
                fmt::format("lists and objects are nested more than {} deep; a scene of "
                            "SPlisHSPlasH needs 5",
                            deepest_json));
  nlohmann::json parsed;
  try {
    parsed = nlohmann::json::parse(json);
  } catch (const nlohmann::json::parse_error& e) {
    const std::string reason = reason_of(e.what());
    throw Error(Error::Kind::scene, file + ":" + line_and_column(json, e.byte > 0 ? e.byte - 1 : 0),
                fmt::format("this file is not JSON: {}{}", reason, remedy_of(reason)));
  } catch (const nlohmann::json::exception&) {  // a number out of range
    throw Error(Error::Kind::scene, file,
                "a number is too large for JSON; write numbers below 1e308");
  }
  if (!parsed.is_object())
    throw Error(Error::Kind::scene, file,
                "the scene is not an object; a scene of SPlisHSPlasH begins with a brace: "
                "{\"Configuration\": {...}}");
  return parsed;
}

}  // namespace freshet
