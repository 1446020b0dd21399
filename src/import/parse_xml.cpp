// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <pugixml.hpp>

#include "freshet/error.h"
#include "import/json_places.h"
#include "import/text_of_path.h"
#include "import/xml_tree.h"

namespace freshet {
namespace {

[[noreturn]] void reject_xml(const std::string& xml, const std::string& file, std::ptrdiff_t byte,
                             const std::string& message) {
  const std::size_t at = byte < 0 ? 0 : std::min(std::size_t(byte), xml.size());
  throw Error(Error::Kind::scene, file + ":" + line_and_column(xml, at), message);
}

std::string without_spaces(const std::string& text) {
  const auto begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

/// A name that starts with an underscore is switched off in DualSPHysics, as a comment.
bool is_on(const pugi::xml_node& node) {
  return node.type() == pugi::node_element && node.name()[0] != '_';
}

XmlNode xml_node(const pugi::xml_node& from, const std::string& path, int depth,
                 const std::string& xml, const std::string& file) {
  if (depth > deepest_xml)
    reject_xml(xml, file, from.offset_debug(),
               fmt::format("elements are nested deeper than {}", deepest_xml));
  XmlNode node;
  node.name = from.name();
  node.path = path;
  node.byte = std::size_t(std::max<std::ptrdiff_t>(0, from.offset_debug()));
  node.text = without_spaces(from.text().get());
  for (const pugi::xml_attribute& a : from.attributes())
    if (a.name()[0] != '_') node.attributes.push_back({a.name(), a.value(), false});
  std::map<std::string, std::size_t> counts, seen;
  for (const pugi::xml_node& child : from.children())
    if (is_on(child)) ++counts[child.name()];
  for (const pugi::xml_node& child : from.children()) {
    if (!is_on(child)) continue;
    std::string below = path_below(path, child.name());
    // <parameter key="Visco" value="0.1" /> is parameter[Visco]
    if (const char* key = child.attribute("key").value(); *key != 0)
      below += fmt::format("[{}]", key);
    else if (counts[child.name()] > 1) below = path_below(below, seen[child.name()]++);
    node.children.push_back(xml_node(child, below, depth + 1, xml, file));
  }
  return node;
}

}  // namespace

bool reads_xml() { return true; }

XmlNode parse_xml(const std::string& xml, const std::string& file) {
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(xml.data(), xml.size());
  if (!result)
    reject_xml(xml, file, result.offset,
               fmt::format("is not XML: {}; write a case of DualSPHysics, such as Case_Def.xml",
                           result.description()));
  return xml_node(document.document_element(), "", 0, xml, file);
}

}  // namespace freshet
