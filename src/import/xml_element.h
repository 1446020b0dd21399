// SPDX-License-Identifier: MIT
/// Reads the elements of a case in XML. Every element is read, listed as a note, or unknown.
#pragma once
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/vec.h"
#include "import/findings.h"
#include "import/xml_tree.h"

namespace freshet {

/// Finds the places of elements in an XML text.
class XmlFindings : public ImportFindings {
 public:
  XmlFindings(std::string_view xml, const XmlNode& root, std::string file)
      : ImportFindings(std::move(file)), xml_(xml), root_(root) {}

 protected:
  std::string place(const std::string& path) const override;

 private:
  std::string_view xml_;
  const XmlNode& root_;
};

class XmlElement {
 public:
  using Point = Vec<3, double>;

  /// `node`: null for an element that is missing; it has no attributes.
  XmlElement(const XmlNode* node, ImportFindings& findings);

  explicit operator bool() const { return node_ != nullptr; }
  const std::string& name() const { return node_->name; }
  const std::string& path() const { return node_->path; }
  bool has(const std::string& attribute) const;
  /// The text between the tags.
  std::string body() const { return node_ ? node_->text : ""; }

  /// Each returns `fallback` if the attribute is missing, or after it has reported an error.
  double number(const std::string& attribute, double fallback, double min = -1e15) const;
  long integer(const std::string& attribute, long fallback) const;
  std::string text(const std::string& attribute, const std::string& fallback) const;
  bool boolean(const std::string& attribute, bool fallback) const;
  /// The attributes x, y and z.
  Point point(Point fallback = {}) const;

  /// The first child of this name, or a missing element.
  XmlElement child(const std::string& name) const;
  std::vector<XmlElement> children(const std::string& name) const;
  std::vector<XmlElement> children() const;

  void error(const std::string& message) const;
  /// Notes about the element as a whole; nothing if it is missing.
  void instead(const std::string& message) const;
  void missing(const std::string& message) const;
  void display() const;
  /// Neither the element nor what is in it needs a note.
  void skip() const;

 private:
  std::optional<std::string> find(const std::string& attribute) const;
  void note(ImportNote::Kind kind, const std::string& message) const;

  const XmlNode* node_;
  ImportFindings* findings_;
};

/// Notes all elements and attributes that were neither read nor noted.
void finish_xml(const XmlNode& root, ImportFindings& findings);

/// The numbers of "1,3-5". Nothing if it is not such a list.
std::vector<long> numbers_of_list(const std::string& list);

}  // namespace freshet
