// SPDX-License-Identifier: MIT
/// An XML document as a tree that knows the places of its elements.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace freshet {

struct XmlAttribute {
  std::string name, value;
  mutable bool used = false;
};

struct XmlNode {
  std::string name, path, text;  ///< path: "casedef.geometry.definition"; text: without spaces
  std::size_t byte = 0;
  std::vector<XmlAttribute> attributes;
  std::vector<XmlNode> children;
  mutable bool used = false;  ///< the element itself, not its attributes and children
};

constexpr int deepest_xml = 64;
/// The root of an XML document. Throws Error (kind scene) at FILE:LINE:COLUMN.
XmlNode parse_xml(const std::string& xml, const std::string& file);
bool reads_xml();

}  // namespace freshet
