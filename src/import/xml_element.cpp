// SPDX-License-Identifier: MIT
#include "import/xml_element.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/text.h"
#include "import/json_places.h"
#include "import/text_of_path.h"
#include "import/toml_text.h"

namespace freshet {
namespace {

/// Attributes that only people read.
const std::set<std::string, std::less<>> remarks{"comment", "units_comment", "cmt", "rem"};

void use_all(const XmlNode& node) {
  node.used = true;
  for (const XmlAttribute& a : node.attributes) a.used = true;
  for (const XmlNode& child : node.children) use_all(child);
}

const XmlNode* find_path(const XmlNode& node, const std::string& path) {
  if (node.path == path) return &node;
  for (const XmlNode& child : node.children)
    if (path.starts_with(child.path))
      if (const XmlNode* found = find_path(child, path)) return found;
  return nullptr;
}

std::string shown_xml(std::string text) {
  if (text.size() > 40) text = text.substr(0, 37) + "...";
  return toml_string(text);
}

/// Whether an element or one in it was read.
bool is_used(const XmlNode& node) {
  return node.used || std::any_of(node.children.begin(), node.children.end(), is_used);
}

}  // namespace

std::string XmlFindings::place(const std::string& path) const {
  const XmlNode* node = &root_;
  for (std::string at = path; !at.empty();) {  // an attribute has the place of its element
    if (const XmlNode* found = find_path(root_, at)) {
      node = found;
      break;
    }
    const auto dot = at.rfind('.');
    at = dot == std::string::npos ? "" : at.substr(0, dot);
  }
  return file() + ":" + line_and_column(xml_, node->byte);
}

XmlElement::XmlElement(const XmlNode* node, ImportFindings& findings)
    : node_(node), findings_(&findings) {
  if (node_) node_->used = true;
}

std::optional<std::string> XmlElement::find(const std::string& attribute) const {
  if (!node_) return std::nullopt;
  for (const XmlAttribute& a : node_->attributes)
    if (a.name == attribute) {
      a.used = true;
      return a.value;
    }
  return std::nullopt;
}

bool XmlElement::has(const std::string& attribute) const {
  return node_ && std::any_of(node_->attributes.begin(), node_->attributes.end(),
                              [&](const XmlAttribute& a) { return a.name == attribute; });
}

double XmlElement::number(const std::string& attribute, double fallback, double min) const {
  const std::optional<std::string> found = find(attribute);
  if (!found) return fallback;
  const char* begin = found->c_str();
  char* end = nullptr;
  const double value = std::strtod(begin, &end);
  while (*end == ' ') ++end;
  if (end != begin && *end == 0 && std::abs(value) <= 1e15 && value >= min) return value;
  const bool formula = found->starts_with('#') || found->find('[') != std::string::npos;
  findings_->error(path_below(path(), attribute),
                   fmt::format("{} is {}; {}", path_below(path(), attribute), shown_xml(*found),
                               formula       ? "write the number: formulas are not computed"
                               : min > -1e15 ? fmt::format("it must be a number ≥ {:g}", min)
                                             : std::string("it must be a number")));
  return fallback;
}

long XmlElement::integer(const std::string& attribute, long fallback) const {
  const double value = number(attribute, double(fallback));
  if (value == std::floor(value) && std::abs(value) < 1e9) return long(value);
  findings_->error(path_below(path(), attribute),
                   fmt::format("{} must be an integer", path_below(path(), attribute)));
  return fallback;
}

std::string XmlElement::text(const std::string& attribute, const std::string& fallback) const {
  return find(attribute).value_or(fallback);
}

bool XmlElement::boolean(const std::string& attribute, bool fallback) const {
  const std::optional<std::string> found = find(attribute);
  if (!found) return fallback;
  if (*found == "true" || *found == "1") return true;
  if (*found == "false" || *found == "0") return false;
  findings_->error(path_below(path(), attribute),
                   fmt::format("{} is {}; it must be true or false", path_below(path(), attribute),
                               shown_xml(*found)));
  return fallback;
}

XmlElement::Point XmlElement::point(Point fallback) const {
  return {number("x", fallback.x), number("y", fallback.y), number("z", fallback.z)};
}

XmlElement XmlElement::child(const std::string& name) const {
  if (node_)
    for (const XmlNode& child : node_->children)
      if (child.name == name) return {&child, *findings_};
  return {nullptr, *findings_};
}

std::vector<XmlElement> XmlElement::children(const std::string& name) const {
  std::vector<XmlElement> all;
  if (node_)
    for (const XmlNode& child : node_->children)
      if (child.name == name) all.emplace_back(&child, *findings_);
  return all;
}

std::vector<XmlElement> XmlElement::children() const {
  std::vector<XmlElement> all;
  if (node_)
    for (const XmlNode& child : node_->children) all.emplace_back(&child, *findings_);
  return all;
}

void XmlElement::error(const std::string& message) const {
  findings_->error(path(), fmt::format("{} {}", path(), message));
}

void XmlElement::note(ImportNote::Kind kind, const std::string& message) const {
  if (!node_) return;
  use_all(*node_);
  findings_->note(kind, path(), message);
}

void XmlElement::instead(const std::string& message) const {
  note(ImportNote::Kind::instead, message);
}

void XmlElement::missing(const std::string& message) const {
  note(ImportNote::Kind::missing, message);
}

void XmlElement::display() const {
  note(ImportNote::Kind::display, "only for the files, the steps and the drawing of DualSPHysics");
}

void XmlElement::skip() const {
  if (node_) use_all(*node_);
}

void finish_xml(const XmlNode& node, ImportFindings& findings) {
  if (!is_used(node)) {
    findings.note(ImportNote::Kind::missing, node.path, "has no counterpart");
    return;
  }
  for (const XmlAttribute& a : node.attributes)
    if (!a.used && !remarks.contains(a.name))
      findings.note(ImportNote::Kind::missing, path_below(node.path, a.name), "has no counterpart");
  for (const XmlNode& child : node.children) finish_xml(child, findings);
}

std::vector<long> numbers_of_list(const std::string& list) {
  std::vector<long> all;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::string item = list.substr(begin, end - begin);
    begin = end + 1;
    char* rest = nullptr;
    const long first = std::strtol(item.c_str(), &rest, 10);
    long last = first;
    if (rest == item.c_str()) return {};
    if (*rest == '-') last = std::strtol(rest + 1, &rest, 10);
    if (*rest != 0 || last < first || last - first > 100000) return {};
    for (long k = first; k <= last; ++k) all.push_back(k);
  }
  return all;
}

}  // namespace freshet
