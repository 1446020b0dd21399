// SPDX-License-Identifier: MIT
#include <algorithm>

#include "import/dualsphysics_cases.h"

namespace freshet::test {
namespace {

void expect_near(const Vector& expected, const Vector& actual) {
  ASSERT_EQ(expected.size(), actual.size());
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(expected[k], actual[k], 1e-6) << k;
}

/// The messages of the notes about an element.
std::vector<std::string> messages_of(const ImportedScene& scene, const std::string& key) {
  std::vector<std::string> all;
  for (const ImportNote& note : scene.notes)
    if (note.key == key) all.push_back(note.message);
  return all;
}

long places_of(const Scene& s) {
  long n = 0;
  for (const Scene::Fluid& f : s.fluid) {
    long places = 1;
    for (const auto count : f.count) places *= long(count);
    n += places;
  }
  return n;
}

TEST(DualSphysics, DamBreakHasItsTankItsPlacesAndItsSolver) {
  const Scene s = CaseFolder().scene();
  expect_near({0.025, 0.025}, s.domain.min);  // half a spacing before the boundary particles
  EXPECT_NEAR(1.975, s.domain.max[0], 1e-6);
  EXPECT_EQ(WallMethod::open, *s.walls.y_max);
  ASSERT_EQ(1u, s.fluid.size());
  expect_near({0.05, 0.05}, s.fluid[0].from);  // the boundary took the places at 0
  EXPECT_EQ((Counts{10, 20}), s.fluid[0].count);
  EXPECT_EQ("delta_sph", std::string(s.method().name));
  EXPECT_NEAR(0.02, *s.solver.artificial_viscosity, 1e-9);
  EXPECT_NEAR(20 * std::sqrt(9.81 * 0.95), *s.solver.sound_speed, 1e-5);
  EXPECT_NEAR(2 * std::sqrt(2.0) * 0.05, *s.particles.support_radius, 1e-6);
  EXPECT_DOUBLE_EQ(0.05, s.time.end);
  EXPECT_TRUE(s.wall.empty());
}

TEST(DualSphysics, EveryElementIsReadOrListed) {
  std::string xml = case_with_commands("<drawellipsoid radius=\"1\" /><shapeout file=\"\" />");
  xml.replace(xml.find("<parameter key"), 0,
              "<parameter key=\"Colour\" value=\"1\" /><_parameter key=\"Off\" value=\"1\" />");
  const ImportedScene scene = CaseFolder(xml).import();
  const std::string mainlist = "casedef.geometry.commands.mainlist.";
  EXPECT_EQ(1u, messages_of(scene, mainlist + "drawellipsoid").size());
  EXPECT_EQ(1u, messages_of(scene, mainlist + "shapeout").size());
  EXPECT_EQ((std::vector<std::string>{"has no counterpart"}),
            messages_of(scene, "execution.parameters.parameter[Colour].value"));
  EXPECT_EQ(3u, scene.notes.size());
}

TEST(DualSphysics, VoidTakesFluidAway) {
  const Scene s = CaseFolder(case_before_tank(R"(<setmkvoid /><drawbox><boxfill>solid</boxfill>
      <point x="0" y="-1" z="0.53" /><size x="0.5" y="2" z="1" /></drawbox>)"))
                      .scene();
  EXPECT_EQ(100, places_of(s));  // up to z = 0.5
}

TEST(DualSphysics, FillingStopsAtBoundaries) {
  // A plate at x = 1 divides the tank; the rest of the left side is filled.
  const Scene s = CaseFolder(case_with_commands(R"(<setmkbound mk="1" />
      <drawbox><boxfill>solid</boxfill><point x="1" y="-1" z="0" /><size x="0.05" y="2" z="1.5" /></drawbox>
      <setmkfluid mk="1" /><fillbox x="0.7" y="0" z="0.1"><modefill>void</modefill>
      <point x="-1" y="-1" z="-1" /><size x="5" y="2" z="1.5" /></fillbox>)"))
                      .scene();
  EXPECT_EQ(200 + 9 * 10, places_of(s));  // from x = 0.55 to 0.95, z = 0.05 to 0.5
  ASSERT_EQ(1u, s.wall.size());
  expect_near({0.975, -0.025}, s.wall[0].min);
  expect_near({1.075, 1.525}, s.wall[0].max);
}

TEST(DualSphysics, SidesHalfwayBetweenPlacesAreTight) {
  // The floor at z = -0.025 and the side at x = -0.025 take the upper places.
  const Scene s = CaseFolder(case_with(R"(<point x="0" y="-1" z="0" />
            <size x="2" y="2" z="1.5" />)",
                                       R"(<point x="-0.025" y="-1" z="-0.025" />
            <size x="1.55" y="2" z="1.5" />)"))
                      .scene();
  EXPECT_EQ((Counts{10, 20}), s.fluid[0].count);
  expect_near({0.025, 0.025}, s.domain.min);
}

TEST(DualSphysics, ListsRunAndMove) {
  std::string xml = case_with_commands(R"(<setmkbound mk="5" /><move x="1" y="0" z="0" />
      <move x="0" y="0" z="0.1" /><runlist name="post" times="3" />)");
  xml.replace(xml.find("<mainlist>"), 0, R"(<list name="post"><drawbox><boxfill>solid</boxfill>
      <point x="0" y="-1" z="0" /><size x="0.1" y="2" z="0.2" /></drawbox>
      <move x="0.3" y="0" z="0" /><setmknextbound next="true" /></list>)");
  xml.replace(xml.find("</geometry>") + 11, 0,
              R"(<floatings><floating mkbound="6-7" relativeweight="0.5" /></floatings>)");
  const Scene s = CaseFolder(xml).scene();
  ASSERT_EQ(1u, s.wall.size());
  ASSERT_EQ(2u, s.body.size());
  EXPECT_EQ("mk_7", s.body[1].name);
  EXPECT_DOUBLE_EQ(500, *s.body[1].density);
  EXPECT_EQ(BodyMotion::free, s.body[1].motion);
  expect_near({1.6, 0.1}, s.body[1].min);  // free bodies have their drawn size
}

TEST(DualSphysics, SidesOfAPrismAreAFloor) {
  // A ramp from (0, 0) over (1, 0) to (2, 0.5); the ends, the right side and the top are hidden.
  const Scene s = CaseFolder(case_with_commands(R"(<setmkbound mk="3" /><drawprism mask="1|2|5|6">
      <point x="0" y="-1" z="0" /><point x="1" y="-1" z="0" /><point x="2" y="-1" z="0.5" />
      <point x="2" y="-1" z="1" /><point x="0" y="1" z="0" /><point x="1" y="1" z="0" />
      <point x="2" y="1" z="0.5" /><point x="2" y="1" z="1" /></drawprism>)"))
                      .scene();
  ASSERT_EQ(1u, s.wall.size());
  EXPECT_EQ(Shape::polygon, s.wall[0].shape);
  ASSERT_EQ(6u, s.wall[0].points.size());
  expect_near({0, 0.025}, s.wall[0].points[0]);
}

TEST(DualSphysics, MotionsBecomeKeyFrames) {
  const std::string piston = R"(<setmkbound mk="9" /><drawbox><boxfill>solid</boxfill>
      <point x="1.5" y="-1" z="0.3" /><size x="0.1" y="2" z="0.5" /></drawbox>)";
  const auto moved = [&](const std::string& motion) {
    std::string xml = case_with_commands(piston);
    xml.replace(xml.find("</geometry>") + 11, 0,
                "<motion><objreal ref=\"9\"><begin mov=\"1\" start=\"0.01\" />" + motion +
                    "</objreal></motion>");
    return xml;
  };
  const Scene straight =
      CaseFolder(moved(R"(<mvrect id="1" duration="3"><vel x="-2" y="0" z="0" /></mvrect>)"))
          .scene();
  ASSERT_EQ(1u, straight.body.size());
  ASSERT_EQ(3u, straight.body[0].key.size());
  EXPECT_NEAR(0.05, straight.body[0].key[2].time, 1e-9);
  EXPECT_NEAR(-0.08, straight.body[0].key[2].translation[0], 1e-9);  // 0.04 s at 2 m/s
  const Scene wave = CaseFolder(moved(R"(<mvrectsinu id="1" duration="3" anglesunits="degrees">
      <freq x="0" y="0" z="25" /><ampl x="0" y="0" z="0.1" /><phase x="0" y="0" z="90" /></mvrectsinu>)"))
                         .scene();
  const auto& keys = wave.body[0].key;
  ASSERT_GT(keys.size(), 20u);
  const auto lowest = std::min_element(keys.begin(), keys.end(), [](const auto& a, const auto& b) {
    return a.translation[1] < b.translation[1];
  });
  EXPECT_NEAR(-0.2, lowest->translation[1], 1e-6);  // z is up there; cos less 1, after half a turn
  EXPECT_NEAR(0, keys.back().translation[1], 1e-6);
  const ImportedScene other = CaseFolder(moved("<mvunknown id=\"1\" duration=\"3\" />")).import();
  EXPECT_EQ(1u, messages_of(other, "casedef.motion.objreal.mvunknown").size());
}

TEST(DualSphysics, InThreeDimensionsZBecomesY) {
  std::string xml = case_with("y=\"0\" z=\"-1\"", "y=\"-0.5\" z=\"-1\"");
  xml.replace(xml.find("y=\"0\" z=\"3\""), 11, "y=\"0.3\" z=\"3\"");
  for (std::size_t at; (at = xml.find("y=\"-1\"")) != std::string::npos;)
    xml.replace(at, 6, "y=\"0\"");
  for (std::size_t at; (at = xml.find("y=\"2\"")) != std::string::npos;)
    xml.replace(at, 5, "y=\"0.2\"");
  xml.replace(xml.find("bottom |"), 8, "bottom|front|back|");
  const Scene s = CaseFolder(xml).scene();
  EXPECT_EQ(3, s.dimension());
  expect_near({0.025, 0.025, -0.175}, s.domain.min);
  EXPECT_EQ((Counts{10, 20, 3}), s.fluid[0].count);  // z = -0.15 to -0.05
}

TEST(DualSphysics, BadCasesNameThePlaceAndTheRemedy) {
  EXPECT_EQ(
      "case.xml:4:3: error: is not XML: Start-end tags mismatch; write a case of "
      "DualSPHysics, such as Case_Def.xml",
      CaseFolder("<case>\n<casedef>\n<geometry>\n</casedef></case>").refused());
  EXPECT_EQ(
      "case.xml:1:2: error: is not a case of DualSPHysics: it needs <case> with <casedef>; "
      "name a file such as Case_Def.xml",
      CaseFolder("<scene/>").refused());
  EXPECT_EQ(
      "case.xml:11:8: error: casedef.geometry.definition needs dp > 0, the distance of "
      "particles [m]",
      CaseFolder(case_with("dp=\"0.05\"", "dp=\"0\"")).refused());
  EXPECT_EQ(
      "case.xml:21:14: error: casedef.geometry.commands.mainlist.drawbox[0].size.x is "
      "\"#Dp*3\"; write the number: formulas are not computed",
      CaseFolder(case_with("size x=\"0.5\"", "size x=\"#Dp*3\"")).refused());
  const std::string sides = CaseFolder(case_with("bottom |", "botom |")).refused();
  EXPECT_TRUE(contains(sides, "has the boxfill \"botom\"; it must be solid, all, or sides"))
      << sides;
  std::string deep;
  for (int k = 0; k < 100; ++k) deep += "<a>";
  for (int k = 0; k < 100; ++k) deep += "</a>";
  EXPECT_TRUE(contains(CaseFolder(deep).refused(), "elements are nested deeper than 64"));
}

}  // namespace
}  // namespace freshet::test
