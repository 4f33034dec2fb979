#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "striate/base/user_error.hpp"
#include "striate/config/settings.hpp"
#include "striate/config/yaml.hpp"

namespace striate::config {
namespace {

using testing::HasSubstr;

struct InnerSettings {
  double angle_rad = 0.5;
};

template <class V>
void visit(V& v, InnerSettings& s) {
  v.number("angle", s.angle_rad, Unit::angle, {-3.2, 3.2}, "an angle");
}

enum class Mode { paper, robust };

struct OuterSettings {
  int count = 4;
  double speed_m_s = 0.4;
  bool on = false;
  Mode mode = Mode::robust;
  InnerSettings inner;
};

template <class V>
void visit(V& v, OuterSettings& s) {
  v.integer("count", s.count, {1, 10}, "how many");
  v.number("speed", s.speed_m_s, Unit::speed, {0.0, 1.0}, "how fast");
  v.flag("on", s.on, "whether");
  v.choice("mode", s.mode, {"paper", "robust"}, "which");
  v.section("inner", s.inner);
}

struct OldSettings {};

template <class V>
void visit(V& v, OldSettings& /*s*/) {
  v.retired("gain", "the camera says it");
}

OuterSettings read(const std::string& yaml, Diagnostics& diagnostics) {
  OuterSettings settings;
  const Node root = parse_yaml(yaml, diagnostics);
  SettingsReader reader(root, "settings", diagnostics);
  visit(reader, settings);
  reader.finish();
  return settings;
}

TEST(Settings, ReadUnitsAndSections) {
  Diagnostics diagnostics("f.yaml");
  const OuterSettings s = read(
      "count: 7\nspeed: 30 cm/s\non: true\nmode: paper\ninner: {angle: 90 deg}\n", diagnostics);
  EXPECT_TRUE(diagnostics.none()) << diagnostics.text();
  EXPECT_EQ(s.count, 7);
  EXPECT_NEAR(s.speed_m_s, 0.3, 1e-12);
  EXPECT_TRUE(s.on);
  EXPECT_EQ(s.mode, Mode::paper);
  EXPECT_NEAR(s.inner.angle_rad, 1.5707963, 1e-6);
}

TEST(Settings, ARetiredKeyIsAWarningAndNoMistake) {
  Diagnostics diagnostics("f.yaml");
  const std::string yaml = "gain: 3\n";
  diagnostics.set_source(yaml);
  const Node root = parse_yaml(yaml, diagnostics);
  OldSettings settings;
  SettingsReader reader(root, "settings", diagnostics);
  visit(reader, settings);
  reader.finish();
  EXPECT_TRUE(diagnostics.none()) << diagnostics.text();
  EXPECT_EQ(diagnostics.warnings(),
            "f.yaml:1:1: warning: 'gain' has no effect any more\n"
            "    gain: 3\n"
            "    ^\n"
            "    the camera says it\n");
  SettingsPrinter printer;
  visit(printer, settings);
  EXPECT_TRUE(printer.lines().empty());
}

TEST(Settings, TellAllDiagnosticsInOnePassWithTheirPlaces) {
  Diagnostics diagnostics("f.yaml");
  read(
      "count: 70\n"
      "sped: 0.3 m/s\n"
      "on: yes\n"
      "mode: papre\n"
      "inner:\n"
      "  angle: 90\n"
      "  angle: 1 m\n",
      diagnostics);
  const std::string text = diagnostics.text();
  EXPECT_THAT(text, HasSubstr("f.yaml:1:8: error: '70' is out of range"));
  EXPECT_THAT(text, HasSubstr("f.yaml:2:1: error: unknown key 'sped'"));
  EXPECT_THAT(text, HasSubstr("did you mean 'speed'?"));
  EXPECT_THAT(text, HasSubstr("f.yaml:3:5: error: 'yes' is neither true nor false"));
  EXPECT_THAT(text, HasSubstr("f.yaml:4:7: error: 'papre' is not known as 'mode'"));
  EXPECT_THAT(text, HasSubstr("did you mean 'paper'?"));
  EXPECT_THAT(text, HasSubstr("f.yaml:6:10: error: '90' has no unit"));
  EXPECT_THAT(text, HasSubstr("f.yaml:7:3: error: duplicate key 'angle'"));
  EXPECT_EQ(diagnostics.list().size(), 6U);
  EXPECT_THROW(diagnostics.throw_if_any(), UserError);
}

TEST(Settings, PrintedSettingsReadBackTheSame) {
  OuterSettings settings;
  settings.speed_m_s = 0.123456789;
  SettingsPrinter printer;
  visit(printer, settings);
  std::string yaml;
  std::string inner;
  for (const SettingLine& line : printer.lines()) {
    const auto dot = line.key.find('.');
    if (dot == std::string::npos) {
      yaml += line.key + ": " + line.value + "\n";
    } else {
      inner += "  " + line.key.substr(dot + 1) + ": " + line.value + "\n";
    }
  }
  Diagnostics diagnostics("f.yaml");
  const OuterSettings back = read(yaml + "inner:\n" + inner, diagnostics);
  EXPECT_TRUE(diagnostics.none()) << diagnostics.text();
  EXPECT_DOUBLE_EQ(back.speed_m_s, settings.speed_m_s);
  EXPECT_NEAR(back.inner.angle_rad, settings.inner.angle_rad, 1e-9);
}

TEST(Quantity, RefusesWhatPeopleMistype) {
  for (const char* text : {"010 m", "0x10 m", ".nan m", "inf m", "1e400 m", "m", "", "'3 m'",
                           "3 parsec", "3 s", "1,5 m", "--3 m", "1 m m"}) {
    Diagnostics diagnostics("f.yaml");
    const Node root = parse_yaml(std::string("v: ") + text + "\n", diagnostics);
    const Node::Entry* entry = root.find("v");
    ASSERT_NE(entry, nullptr) << text;
    EXPECT_FALSE(read_quantity(entry->value, Unit::length, {-1e9, 1e9}, diagnostics)) << text;
    EXPECT_EQ(diagnostics.list().size(), 1U) << text << "\n" << diagnostics.text();
  }
}

TEST(Yaml, RefusesAliasBombsTagsAndDepth) {
  Diagnostics bomb("f.yaml");
  parse_yaml("a: &x [1, 2]\nb: [*x, *x]\n", bomb);
  EXPECT_THAT(bomb.text(), HasSubstr("f.yaml:1:4: error: anchors"));

  Diagnostics tag("f.yaml");
  parse_yaml("a: !!binary abc\n", tag);
  EXPECT_THAT(tag.text(), HasSubstr("tags"));

  Diagnostics deep("f.yaml");
  parse_yaml(std::string(40, '[') + std::string(40, ']'), deep);
  EXPECT_THAT(deep.text(), HasSubstr("nested deeper"));

  Diagnostics two("f.yaml");
  parse_yaml("a: 1\n---\nb: 2\n", two);
  EXPECT_THAT(two.text(), HasSubstr("second YAML document"));

  Diagnostics broken("f.yaml");
  parse_yaml("a: [1, 2\nb: 3\n", broken);
  EXPECT_THAT(broken.text(), HasSubstr("not readable as YAML"));

  Diagnostics big("f.yaml");
  parse_yaml(std::string(1'100'000, 'a'), big);
  EXPECT_THAT(big.text(), HasSubstr("larger than 1 MB"));
}

TEST(Yaml, AQuoteThatIsNotClosedIsToldWhereItOpens) {
  for (const std::string& text :
       {std::string("a: 1\nb: \"done\nfinally:\n  - stop\n"), std::string("a: 1\nb: 'done\n"),
        std::string("a: 1\nb: \"done"), std::string("a: 1\r\nb: \"done\r\n\r\n"),
        std::string("a: 1\nb: \"do\\\"ne 'x'\n # not a comment\n"),
        std::string("a: 1\nb: [x, 'y]\n"), std::string("a: 1\n\"b: c\n")}) {
    Diagnostics diagnostics("f.yaml");
    (void)parse_yaml(text, diagnostics);
    EXPECT_THAT(diagnostics.text(), HasSubstr("f.yaml:2:")) << text;
    EXPECT_THAT(diagnostics.text(), HasSubstr("this quote is not closed")) << text;
  }
  for (const char* text : {"a: \"b\"\n", "a: 'it''s'", "a: \"b\" # \"c\n", "a: b\"c\n",
                           "a: |\n  \"b\n", "a: \"b\n  c\"\n\n", "--- \"b\"\n...\n"}) {
    Diagnostics diagnostics("f.yaml");
    (void)parse_yaml(text, diagnostics);
    EXPECT_TRUE(diagnostics.none()) << text << diagnostics.text();
  }
}

TEST(Yaml, TextThatNoTerminalShowsIsRefusedAndNotEchoed) {
  for (const char* text :
       {"a: \"x\\e[2Jy\"\n", "a: x\xffy\n", "a: \"x\\u202ey\"\n", "\"a\\x9b\": 1\n"}) {
    Diagnostics diagnostics("f.yaml");
    (void)parse_yaml(text, diagnostics);
    EXPECT_THAT(diagnostics.text(), HasSubstr("f.yaml:1:")) << text;
    for (const char letter : diagnostics.text()) {
      EXPECT_TRUE(letter == '\n' || (letter >= ' ' && letter <= '~')) << diagnostics.text();
    }
  }
  Diagnostics diagnostics("f.yaml");
  (void)parse_yaml("a: |\n  two\n  lines\nb: Büchlein\n", diagnostics);
  EXPECT_TRUE(diagnostics.none()) << diagnostics.text();
}

TEST(Yaml, SaysWhichFileIsMissing) {
  Diagnostics diagnostics("/nowhere/x.yaml");
  load_yaml(diagnostics);
  EXPECT_THAT(diagnostics.text(), HasSubstr("/nowhere/x.yaml: error: there is no such file"));
}

TEST(Diagnostics, ShowTheLineWithACaretUnderThePlace) {
  Diagnostics diagnostics("f.yaml");
  parse_yaml("abc: 1\n  def\n", diagnostics);
  diagnostics.add({1, 6}, "wrong");
  EXPECT_THAT(diagnostics.text(), HasSubstr("    abc: 1\n         ^\n"));
}

}  // namespace
}  // namespace striate::config
