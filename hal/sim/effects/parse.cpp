// SPDX-License-Identifier: MIT
#include <hal/sim/effects/parse.hpp>

#include <algorithm>
#include <charconv>

namespace hal::sim {

namespace {

constexpr std::array<EffectHelp, effect_count> help{{
    {"draw", "=TIME[~TIME]", "drawing a frame takes the program so long, and up to so much more"},
    {"garbage", "[=SEED]", "memory and colours are noise at power-on"},
    {"bus", "[=RATE[+TIME]]", "a write takes as long as its bytes, and so much more a window"},
    {"latch", "=palette|none", "colours, or colours and buffer, change in the middle of a picture"},
    {"te", "[=RATE][+TIME][~TIME] or off",
     "the tearing-effect line: the panel's real rate, phase, jitter; or none"},
    {"drift", "[=PPM[/PERIOD]]", "the refresh rate is off (by 200 ppm), or goes to and fro"},
    {"scan", "=down|up|right|left", "the way the beam goes"},
    {"tearing", "", "pictures are what the beam fetched, torn where frames met"},
    {"depth", "[=BITS or 565]", "bits of a colour that reach the glass"},
    {"gamma", "[=EXPONENT]", "the light that the panel makes of a level (2.2)"},
    {"response", "[=TIME[/TIME]]", "10 to 90 % rise and fall of a pixel's light: ghosting"},
    {"dead", "=X:Y[:RRGGBB]", "a pixel that shows one colour; name it as often as you like"},
    {"grid", "[=SCALE[:rgb|bgr|none]]", "the viewer's picture enlarged, with sub-pixel stripes"},
}};

/// "8 ms", in the largest unit that leaves no rest.
std::string as_time(Nanoseconds time) {
  if (time % 1'000'000'000U == 0 && time > 0) return std::to_string(time / 1'000'000'000U) + " s";
  if (time % 1'000'000U == 0 && time > 0) return std::to_string(time / 1'000'000U) + " ms";
  if (time % 1000U == 0) return std::to_string(time / 1000U) + " us";
  return std::to_string(time) + " ns";
}

std::string as_rate(std::uint64_t hertz) {
  if (hertz % 1'000'000U == 0) return std::to_string(hertz / 1'000'000U) + " MHz";
  if (hertz % 1000U == 0) return std::to_string(hertz / 1000U) + " kHz";
  return std::to_string(hertz) + " Hz";
}

/// What is wrong, for `parse_effects` to hand on.
struct Wrong {
  std::string what;
};

/// Reads a value from the left.
class Reader {
 public:
  Reader(std::string_view text, std::string_view usage) : rest_(text), text_(text), usage_(usage) {}

  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  [[nodiscard]] std::string_view rest() const { return rest_; }
  bool take(char sign) {
    if (!rest_.starts_with(sign)) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void skip(std::size_t count) { rest_.remove_prefix(count); }
  /// A word of the list, and which one.
  std::size_t word(std::initializer_list<std::string_view> words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (rest_ != words.begin()[i]) continue;
      rest_ = {};
      return i;
    }
    fail();
  }
  /// A whole number of least..most, which is called `name`.
  std::uint64_t number(std::string_view name, std::uint64_t least, std::uint64_t most) {
    std::uint64_t value = 0;
    const char* const end = rest_.data() + rest_.size();
    const auto [next, error] = std::from_chars(rest_.data(), end, value);
    if (error == std::errc::invalid_argument) fail();
    if (error != std::errc{} || value < least || value > most)
      fail_range(std::string(name) + " is " + std::to_string(least) + " to " + std::to_string(most));
    rest_ = {next, static_cast<std::size_t>(end - next)};
    return value;
  }
  /// A decimal number times 10^digits. At most `most`, which a user reads as `range`.
  std::uint64_t decimal(int digits, std::uint64_t most, const std::string& range) {
    std::uint64_t value = 0;
    bool any = false;
    int after_point = -1;  // Digits so far; -1: no point yet.
    for (; !rest_.empty(); rest_.remove_prefix(1)) {
      if (rest_[0] == '.' && after_point < 0) {
        after_point = 0;
      } else if (is_digit(rest_[0])) {
        any = true;
        if (after_point == digits) fail_range("at most " + std::to_string(digits) + " decimals");
        if (after_point >= 0) ++after_point;
        value = value * 10U + static_cast<std::uint64_t>(rest_[0] - '0');
        if (value > most) fail_range(range);
      } else {
        break;
      }
    }
    if (!any) fail();
    for (int i = std::max(after_point, 0); i < digits; ++i) {
      value *= 10U;
      if (value > most) fail_range(range);
    }
    return value;
  }
  /// Nanoseconds, at most `most`.
  Nanoseconds time(Nanoseconds most) {
    return with_unit({{"ns", 0}, {"us", 3}, {"ms", 6}, {"s", 9}}, most, as_time(most));
  }
  /// Millihertz, at most `most`.
  std::uint64_t rate(std::uint64_t most) {
    return with_unit({{"hz", 3}, {"khz", 6}, {"mhz", 9}}, most, as_rate(most / 1000U));
  }

  void expect_end() const {
    if (!rest_.empty()) fail();
  }
  [[noreturn]] void fail() const {
    std::string what = "'" + std::string(text_) + "' is no value of " + std::string(usage_);
    if (usage_.find("RATE") != std::string_view::npos) what += ", RATE as in 10MHz";
    if (usage_.find("TIME") != std::string_view::npos || usage_.find("PERIOD") != std::string_view::npos)
      what += ", times as in 8ms";
    throw Wrong{what};
  }
  [[noreturn]] void fail_range(const std::string& range) const {
    throw Wrong{"'" + std::string(text_) + "' is out of range (" + range + "): " + std::string(usage_)};
  }

 private:
  struct Unit {
    std::string_view name;
    int digits;
  };
  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
  static char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

  std::uint64_t with_unit(std::initializer_list<Unit> units, std::uint64_t most, const std::string& limit) {
    // The unit stands behind the number but says how many digits that has.
    const auto letter = [](char c) { return lower(c) >= 'a' && lower(c) <= 'z'; };
    const auto begin = std::ranges::find_if(rest_, letter);
    const auto end = std::find_if_not(begin, rest_.end(), letter);
    std::string name(begin, end);
    std::ranges::transform(name, name.begin(), lower);
    for (const Unit& unit : units) {
      if (unit.name != name) continue;
      const std::uint64_t value = decimal(unit.digits, most, "at most " + limit);
      if (!std::ranges::equal(rest_.substr(0, name.size()), name, {}, lower)) fail();
      rest_.remove_prefix(name.size());
      return value;
    }
    fail();
  }

  std::string_view rest_;
  std::string_view text_;
  std::string_view usage_;
};

constexpr Nanoseconds second = 1'000'000'000;
constexpr const char* depth_range = "1 to 8 bits, or three digits of 1 to 8";

BusTiming read_bus(Reader& value, BusTiming bus) {
  if (value.at_end()) return bus;
  if (value.rest()[0] != '+') {
    const std::uint64_t millihertz = value.rate(4'000'000'000'000U);
    if (millihertz < 1000U || millihertz % 1000U != 0) value.fail_range("whole hertz, at least 1 Hz");
    bus.hertz = static_cast<std::uint32_t>(millihertz / 1000U);
  }
  if (value.take('+')) bus.gap = value.time(second);
  return bus;
}

TeTiming read_te(Reader& value, std::uint32_t nominal) {
  TeTiming te;
  if (value.rest() == "off") {
    value.word({"off"});
    te.connected = false;
    return te;
  }
  if (!value.at_end() && value.rest()[0] != '+' && value.rest()[0] != '~') {
    te.millihertz = static_cast<std::uint32_t>(value.rate(1'000'000));
    if (te.millihertz < 1000U) value.fail_range("1 Hz to 1 kHz");
  }
  if (value.take('+')) te.phase = value.time(second);
  if (value.take('~')) te.jitter = value.time(second);
  const std::uint64_t rate = te.millihertz > 0 ? te.millihertz : nominal;
  // A tenth of the refresh is left for drift.
  if ((te.phase + te.jitter) * rate >= 900U * second)
    value.fail_range("phase and jitter together below nine tenths of a refresh");
  return te;
}

ResponseTime read_response(Reader& value, ResponseTime response) {
  if (value.at_end()) return response;
  constexpr Nanoseconds most = second / 2U;
  response.rise = value.time(most);
  response.fall = value.take('/') ? value.time(most) : response.rise;
  return response;
}

DrawTime read_draw(Reader& value) {
  DrawTime draw{value.time(10U * second), 0};
  if (value.take('~')) draw.spread = value.time(10U * second);
  return draw;
}

RefreshDrift read_drift(Reader& value) {
  RefreshDrift drift;
  if (value.at_end()) return drift;
  const bool slower = value.take('-');
  if (!slower) value.take('+');
  drift.ppm = static_cast<int>(value.number("PPM", 0, 50'000)) * (slower ? -1 : 1);
  if (value.rest().starts_with("ppm")) value.skip(3);
  if (!value.take('/')) return drift;
  drift.period = value.time(60U * second);
  if (drift.period < second / 10U) value.fail_range("a period of 100 ms to 60 s");
  return drift;
}

ColourDepth read_depth(Reader& value, ColourDepth depth) {
  if (value.at_end()) return depth;
  const std::string_view digits = value.rest();
  if (digits.size() != 1 && digits.size() != 3) value.fail_range(depth_range);
  for (std::size_t i = 0; i < 3; ++i) {
    const char digit = digits[digits.size() == 3 ? i : 0];
    if (digit < '1' || digit > '8') value.fail_range(depth_range);
    depth.bits[i] = digit - '0';
  }
  value.skip(digits.size());
  return depth;
}

DeadPixel read_dead(Reader& value, const Capabilities& panel) {
  DeadPixel pixel;
  pixel.x = static_cast<int>(value.number("x", 0, static_cast<std::uint64_t>(panel.width) - 1U));
  if (!value.take(':')) value.fail();
  pixel.y = static_cast<int>(value.number("y", 0, static_cast<std::uint64_t>(panel.height) - 1U));
  if (!value.take(':')) return pixel;
  std::uint32_t colour = 0;
  const std::string_view digits = value.rest();
  const auto [next, error] = std::from_chars(digits.data(), digits.data() + digits.size(), colour, 16);
  if (digits.size() != 6 || error != std::errc{} || next != digits.data() + digits.size()) value.fail();
  for (std::size_t i = 0; i < 3; ++i) {
    pixel.colour[i] = static_cast<std::uint8_t>(colour >> (16U - 8U * static_cast<unsigned>(i)));
  }
  value.skip(digits.size());
  return pixel;
}

PixelGrid read_grid(Reader& value, PixelGrid grid, const Capabilities& panel) {
  if (!value.at_end()) {
    grid.scale = static_cast<int>(value.number("SCALE", 2, 32));
    if (value.take(':')) grid.stripes = static_cast<Stripes>(value.word({"rgb", "bgr", "none"}));
    if (grid.scale < 4 && grid.stripes != Stripes::none)
      value.fail_range("4 to 32, or 2 and more without stripes");
  }
  constexpr int most = 16384;
  if (std::max(panel.width, panel.height) * grid.scale > most)
    value.fail_range("pictures of at most 16384 a side");
  return grid;
}

void read_effect(std::size_t which, Reader& value, const PanelSpec& panel, Effects& effects) {
  const Capabilities& c = panel.capabilities;
  const EffectTable& table = panel.effects;
  switch (static_cast<Effect>(which)) {
    case Effect::draw:
      effects.draw = read_draw(value);
      break;
    case Effect::garbage:
      effects.garbage = PowerOnGarbage{value.at_end() ? 1 : value.number("SEED", 0, ~std::uint64_t{0})};
      break;
    case Effect::bus:
      if (c.buffers > 0)
        throw Wrong{"panel " + panel.name + " is scanned out of the program's memory: no bus"};
      effects.bus = read_bus(value, table.bus);
      break;
    case Effect::latch:
      if (c.buffers == 0) throw Wrong{"panel " + panel.name + " has memory of its own: nothing to latch"};
      effects.latch =
          value.word({"palette", "none"}) == 0 ? PaletteLatch::at_once : PaletteLatch::both_at_once;
      break;
    case Effect::te:
      effects.te = read_te(value, c.refresh_millihertz);
      break;
    case Effect::drift:
      effects.drift = read_drift(value);
      break;
    case Effect::scan:
      effects.scan = static_cast<ScanDirection>(value.word({"down", "up", "right", "left"}));
      break;
    case Effect::tearing:
      effects.tearing = true;
      break;
    case Effect::depth:
      effects.depth = read_depth(value, table.depth);
      break;
    case Effect::gamma: {
      effects.gamma.emplace();
      if (value.at_end()) break;
      effects.gamma->hundredths = static_cast<int>(value.decimal(2, 500, "0.5 to 5"));
      if (effects.gamma->hundredths < 50) value.fail_range("0.5 to 5");
      break;
    }
    case Effect::response:
      effects.response = read_response(value, table.response);
      break;
    case Effect::dead:
      effects.dead.push_back(read_dead(value, c));
      break;
    case Effect::grid:
      effects.grid = read_grid(value, table.grid, c);
      break;
  }
}

}  // namespace

std::span<const EffectHelp, effect_count> effect_help() { return help; }

std::variant<Effects, std::string> parse_effects(std::string_view text, const PanelSpec& panel) {
  Effects effects;
  std::array<bool, effect_count> named{};
  for (bool more = !text.empty(); more;) {
    const std::string_view item = text.substr(0, text.find(','));
    more = item.size() < text.size();
    text.remove_prefix(item.size() + (more ? 1U : 0U));
    const std::string_view name = item.substr(0, item.find('='));
    const auto found = std::ranges::find(help, name, &EffectHelp::name);
    if (found == help.end()) return "no effect is named '" + std::string(name) + "'";
    const auto which = static_cast<std::size_t>(found - help.begin());
    const std::string usage = std::string(found->name) + std::string(found->value);
    if (named[which] && static_cast<Effect>(which) != Effect::dead)
      return "effect " + std::string(name) + " is named twice";
    named[which] = true;
    const bool has_value = name.size() < item.size();
    const std::string_view value_text = has_value ? item.substr(name.size() + 1U) : std::string_view();
    if (has_value && (value_text.empty() || found->value.empty()))
      return value_text.empty() ? "effect " + std::string(name) + " has no value behind '='"
                                : "effect " + std::string(name) + " takes no value";
    if (!has_value && found->value.starts_with('='))
      return "effect " + std::string(name) + " needs a value: " + usage;
    try {
      Reader value(value_text, usage);
      read_effect(which, value, panel, effects);
      value.expect_end();
    } catch (const Wrong& wrong) {
      return "effect " + std::string(name) + ": " + wrong.what;
    }
  }
  return effects;
}

std::string effect_default(Effect effect, const PanelSpec& panel) {
  const EffectTable& table = panel.effects;
  switch (effect) {
    case Effect::bus:
      if (panel.capabilities.buffers > 0) return {};
      return as_rate(table.bus.hertz) + ", " + as_time(table.bus.gap) + " a window";
    case Effect::depth: {
      std::string bits;
      for (const int channel : table.depth.bits) bits += std::to_string(channel);
      return bits;
    }
    case Effect::response:
      return as_time(table.response.rise) + " up, " + as_time(table.response.fall) + " down";
    case Effect::grid:
      return std::to_string(table.grid.scale) +
             (table.grid.stripes == Stripes::none ? ", no stripes" : ", stripes");
    default:
      return {};
  }
}

}  // namespace hal::sim
