// SPDX-License-Identifier: MIT
/// Small cases of DualSPHysics.
#pragma once
#include "freshet/import.h"
#include "freshet/scene.h"
#include "import/import_scenes.h"

namespace freshet::test {

/// A dam break in 2D: a column of 0.5 x 1 m in a tank of 2 x 1.5 m, with a lid missing.
inline const std::string dam_xml = R"(<?xml version="1.0" encoding="UTF-8" ?>
<case>
  <casedef>
    <constantsdef>
      <gravity x="0" y="0" z="-9.81" comment="down" />
      <rhop0 value="1000" />
      <coefsound value="20" />
      <coefh value="1" />
    </constantsdef>
    <geometry>
      <definition dp="0.05">
        <pointmin x="-1" y="0" z="-1" />
        <pointmax x="4" y="0" z="3" />
      </definition>
      <commands>
        <mainlist>
          <setmkfluid mk="0" />
          <drawbox>
            <boxfill>solid</boxfill>
            <point x="0" y="-1" z="0" />
            <size x="0.5" y="2" z="1" />
          </drawbox>
          <setmkbound mk="0" />
          <drawbox>
            <boxfill>bottom | left | right</boxfill>
            <point x="0" y="-1" z="0" />
            <size x="2" y="2" z="1.5" />
          </drawbox>
        </mainlist>
      </commands>
    </geometry>
  </casedef>
  <execution>
    <parameters>
      <parameter key="Visco" value="0.02" />
      <parameter key="DensityDT" value="2" />
      <parameter key="TimeMax" value="0.05" />
      <parameter key="TimeOut" value="0.01" />
    </parameters>
  </execution>
</case>
)";

/// dam_xml with `to` in place of the first `from`.
inline std::string case_with(const std::string& from, const std::string& to) {
  std::string xml = dam_xml;
  const auto at = xml.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return xml.replace(at, from.size(), to);
}
/// dam_xml with more commands, before the tank is drawn or at the end.
inline std::string case_before_tank(const std::string& commands) {
  return case_with("<setmkbound mk=\"0\" />", commands + "<setmkbound mk=\"0\" />");
}
inline std::string case_with_commands(const std::string& commands) {
  return case_with("</mainlist>", commands + "</mainlist>");
}

/// A folder with case.xml.
class CaseFolder : public TemporaryFolder {
 public:
  explicit CaseFolder(const std::string& xml = dam_xml) { write_text(file(), xml); }
  fs::path file() const { return *this / "case.xml"; }
  ImportedScene import() const { return import_dualsphysics(file(), path()); }
  Scene scene() const { return parse_scene(import().toml, (*this / "scene.toml").string()); }
  /// The error message of importing it, without the folder; empty without an error.
  std::string refused() const {
    return refusal_of([&] { import(); }, path());
  }
};

}  // namespace freshet::test
