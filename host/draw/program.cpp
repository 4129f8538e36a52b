// SPDX-License-Identifier: MIT
#include <host/draw/arguments.hpp>
#include <host/draw/methods.hpp>
#include <host/draw/program.hpp>
#include <host/draw/smoothing.hpp>
#include <host/draw/words.hpp>
#include <host/failure.hpp>
#include <intaglio/status_text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <intaglio_fonts/digits_16.hpp>
#include <intaglio_fonts/digits_28.hpp>
#include <intaglio_fonts/digits_48.hpp>
#include <intaglio_fonts/fixed_5x8.hpp>
#include <intaglio_fonts/fixed_6x13.hpp>
#include <intaglio_fonts/sans_11.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace host::draw {
namespace {

using intaglio::Status;
using intaglio::raster::Cap;
using intaglio::raster::FillRule;
using intaglio::text::Font;
using linear::Point;
using linear::SubPoint;

constexpr auto fonts = std::to_array<std::pair<std::string_view, const Font*>>({
    {"fixed_5x8", &intaglio::fonts::fixed_5x8},
    {"fixed_6x13", &intaglio::fonts::fixed_6x13},
    {"sans_11", &intaglio::fonts::sans_11},
    {"digits_16", &intaglio::fonts::digits_16},
    {"digits_28", &intaglio::fonts::digits_28},
    {"digits_48", &intaglio::fonts::digits_48},
});

/// What is wrong, in the library's words.
std::string in_words(Status status) {
  std::string words = fmt::format("{} {}", to_text(status.argument()), to_text(status.error()));
  if (status.needed() != 0) words += fmt::format(" (limit {})", status.needed());
  return words;
}

class Interpreter {
 public:
  void run(std::string_view name, Arguments arguments) {
    const auto command = std::find_if(commands.begin(), commands.end(),
                                      [&](const auto& candidate) { return candidate.first == name; });
    if (command == commands.end()) throw Failure(fmt::format("unknown command '{}'", name));
    const bool is_surface = name == "surface";
    if (!canvas_ && !is_surface) throw Failure("the first command must be 'surface'");
    if (canvas_ && is_surface) throw Failure("a second surface");
    try {
      (this->*command->second)(arguments);
      arguments.end();
      if (pending_) draw();
    } catch (const Failure& failure) {
      throw Failure(fmt::format("{}: {}", name, failure.what()));
    }
  }

  std::shared_ptr<const Canvas> canvas() const { return canvas_; }

 private:
  void surface(Arguments& in) {
    const int width = in.whole("width");
    const int height = in.whole("height");
    const int bits = in.whole("bits");
    if (bits != 1 && bits != 2 && bits != 4 && bits != 8)
      throw Failure(fmt::format("bits must be 1, 2, 4 or 8, not {}", bits));
    const auto made = Canvas::create({width, height}, bits);
    if (!made.ok()) throw Failure(in_words(made.status()));
    canvas_ = made.value();
    pen_.index = canvas_->max_index();
    pen_.clip = {0, 0, width, height};
  }

  void palette(Arguments& in) {
    const int index = in.whole("index", 0, last_index());
    for (std::size_t channel = 0; const std::string_view name : {"red", "green", "blue"})
      colours_[static_cast<std::size_t>(channel++)] = static_cast<std::uint8_t>(in.whole(name, 0, 255));
    in.end();
    std::copy(colours_.begin(), colours_.end(), canvas_->palette().begin() + 3 * index);
  }

  void colour(Arguments& in) { pen_.index = static_cast<unsigned>(in.whole("index", 0, last_index())); }

  void mode(Arguments& in) {
    const std::string& word = in.word("mode").text;
    if (word != "set" && word != "xor") throw Failure(fmt::format("must be set or xor, not '{}'", word));
    pen_.exclusive_or = word == "xor";
  }

  void aa(Arguments& in) {
    if (in.take("off")) {
      pen_.smoothing = nullptr;
      return;
    }
    Smoothing smoothing = parse_smoothing(in.word("method").text);
    if (in.take("light")) smoothing.space = intaglio::image::BlendSpace::light;
    pen_.smoothing = std::make_shared<const Smoothing>(std::move(smoothing));
  }

  void clip(Arguments& in) {
    if (in.left() == 1 && in.next_is("none")) {
      (void)in.word("none");
      pen_.clip = {0, 0, canvas_->size().width, canvas_->size().height};
      return;
    }
    const linear::Rect area = in.rectangle();
    if (!linear::in_domain(area)) throw Failure("rectangle out of domain");
    pen_.clip = area;
  }

  void clippoly(Arguments& in) {
    pen_.window = nullptr;
    if (in.left() == 1 && in.next_is("none")) {
      (void)in.word("none");
      return;
    }
    Polygon polygon;
    polygon.rule = in.next_is("nonzero") ? FillRule::non_zero : FillRule::even_odd;
    if (in.next_is("nonzero") || in.next_is("evenodd")) (void)in.word("rule");
    contours(in, polygon);
    const auto window = PolygonWindow::create(polygon, canvas_->size());
    if (!window.ok()) throw Failure(in_words(window.status()));
    pen_.window = window.value();
  }

  void font(Arguments& in) {
    const std::string& word = in.word("name").text;
    for (const auto& [name, candidate] : fonts)
      if (name == word) {
        font_ = candidate;
        return;
      }
    std::string names;
    for (const auto& [name, candidate] : fonts) names += fmt::format(" {}", name);
    throw Failure(fmt::format("no font '{}'; there are{}", word, names));
  }

  void method(Arguments& in) { method_ = in.word("name").text; }

  /// The method of the primitive at hand.
  template <class T, std::size_t N>
  T chosen(const std::array<std::pair<std::string_view, T>, N>& methods) {
    if (!method_) return methods.front().second;
    const std::string word = *std::exchange(method_, std::nullopt);
    std::string names;
    for (const auto& [name, candidate] : methods) {
      if (name == word) return candidate;
      names += fmt::format(" {}", name);
    }
    throw Failure(fmt::format("no method '{}'; there are{}", word, names));
  }

  void pixel(Arguments& in) { pending_ = Pixel{in.point("x", "y")}; }
  void line(Arguments& in) {
    const SubPoint from = in.subpoint("x0", "y0");
    const SubPoint to = in.subpoint("x1", "y1");
    const LineMethod method = chosen(line_methods);
    if (method != LineMethod::exact && ((from.x | from.y | to.x | to.y) & (linear::subpixel_one - 1)) != 0)
      throw Failure("this method needs whole pixels");
    pending_ = Line{from, to, method};
  }
  void dash(Arguments& in) {
    const int on = in.whole("on");
    const int off = in.whole("off");
    const Point from = in.point("x0", "y0");
    pending_ = Dashes{on, off, from, in.point("x1", "y1")};
  }
  void thickline(Arguments& in) {
    const SubPoint from = in.subpoint("x0", "y0");
    const SubPoint to = in.subpoint("x1", "y1");
    const int width = in.subpixel("width");
    const Cap cap = in.left() > 0 ? in.one_of("cap", caps) : Cap::butt;
    const ThickLineMethod method = chosen(thick_line_methods);
    if (method == ThickLineMethod::minor && (cap != Cap::butt || width % linear::subpixel_one != 0))
      throw Failure("this method needs a whole width and has only butt ends");
    pending_ = ThickLine{from, to, width, cap, method};
  }
  void polyline(Arguments& in) {
    Polyline line;
    line.stroke.width = in.subpixel("width");
    line.stroke.join = in.one_of("join", joins);
    for (const auto& [name, cap] : caps)
      if (in.take(name)) line.stroke.cap = cap;
    line.stroke.closed = in.take("closed");
    if (in.take("limit")) line.stroke.miter_limit = in.subpixel("limit");
    do line.points.push_back(in.subpoint());
    while (in.left() > 0);
    pending_ = std::move(line);
  }
  void rect(Arguments& in) { pending_ = Rectangle{in.rectangle(), false}; }
  void fillrect(Arguments& in) { pending_ = Rectangle{in.rectangle(), true}; }
  void circle(Arguments& in) { pending_ = round(in, false); }
  void disc(Arguments& in) { pending_ = round(in, true); }
  void evencircle(Arguments& in) { pending_ = diametric(in, false); }
  void evendisc(Arguments& in) { pending_ = diametric(in, true); }
  void ellipse(Arguments& in) { pending_ = oval(in, false); }
  void fillellipse(Arguments& in) { pending_ = oval(in, true); }
  void ring(Arguments& in) {
    const Point centre = in.point("x", "y");
    const int inner_radius = in.whole("inner radius");
    pending_ = Ring{centre, inner_radius, in.whole("outer radius")};
  }
  void arc(Arguments& in) { pending_ = swept(in, SweptShape::arc); }
  void pie(Arguments& in) { pending_ = swept(in, SweptShape::pie); }
  void chord(Arguments& in) { pending_ = swept(in, SweptShape::chord); }
  void ellipsearc(Arguments& in) { pending_ = swept_oval(in, SweptShape::arc); }
  void ellipsepie(Arguments& in) { pending_ = swept_oval(in, SweptShape::pie); }
  void ellipsechord(Arguments& in) { pending_ = swept_oval(in, SweptShape::chord); }
  void roundrect(Arguments& in) { pending_ = rounded(in, false); }
  void fillroundrect(Arguments& in) { pending_ = rounded(in, true); }
  void triangle(Arguments& in) {
    const SubPoint a = in.subpoint();
    const SubPoint b = in.subpoint();
    pending_ = Triangle{a, b, in.subpoint(), chosen(triangle_methods)};
  }

  void polygon(Arguments& in) {
    Polygon polygon;
    const std::string& rule = in.word("rule").text;
    if (rule != "evenodd" && rule != "nonzero")
      throw Failure(fmt::format("the rule must be evenodd or nonzero, not '{}'", rule));
    polygon.rule = rule == "evenodd" ? FillRule::even_odd : FillRule::non_zero;
    contours(in, polygon);
    polygon.method = chosen(polygon_methods);
    pending_ = std::move(polygon);
  }

  void coverage(Arguments& in) {
    if (canvas_->max_index() != 255) throw Failure("the surface must have 8 bits a pixel");
    Polygon polygon;
    polygon.rule = FillRule::even_odd;
    contours(in, polygon);
    pending_ = Coverage{std::move(polygon)};
  }

  /// All that is left of the line: vertices, and / between contours.
  static void contours(Arguments& in, Polygon& polygon) {
    std::size_t contour_begin = 0;
    const auto end_contour = [&] {
      const std::size_t length = polygon.vertices.size() - contour_begin;
      if (length < 3) throw Failure(fmt::format("a contour needs 3 vertices, this has {}", length));
      polygon.contour_lengths.push_back(static_cast<int>(length));
      contour_begin = polygon.vertices.size();
    };
    while (in.left() > 0) {
      if (in.next_is("/")) {
        (void)in.word("/");
        end_contour();
      } else {
        polygon.vertices.push_back(in.subpoint());
      }
    }
    end_contour();
  }

  void boolean(Arguments& in) {
    using intaglio::clip::BooleanRule;
    static constexpr std::array<std::pair<std::string_view, BooleanRule>, 4> rules{
        {{"intersection", BooleanRule::intersection},
         {"union", BooleanRule::join},
         {"a-b", BooleanRule::a_minus_b},
         {"b-a", BooleanRule::b_minus_a}}};
    const std::string& word = in.word("operation").text;
    const auto* const rule =
        std::find_if(rules.begin(), rules.end(), [&](const auto& known) { return known.first == word; });
    if (rule == rules.end())
      throw Failure(fmt::format("the operation must be intersection, union, a-b or b-a, not '{}'", word));
    Combination combination{rule->second, {}, {}};
    while (in.left() > 0 && !in.next_is("/")) combination.a.push_back(in.subpoint());
    (void)in.word("the second polygon after /");
    while (in.left() > 0) combination.b.push_back(in.subpoint());
    for (const auto& operand : {combination.a, combination.b})
      if (operand.size() < 3)
        throw Failure(fmt::format("a polygon needs 3 vertices, this has {}", operand.size()));
    Status status;
    canvas_->print(describe(combination, status));
    if (!status.ok()) throw Failure(in_words(status));
    pending_ = std::move(combination);
  }

  void flood(Arguments& in) {
    using intaglio::raster::Connectivity;
    const std::string& neighbours = in.word("neighbours").text;
    if (neighbours != "4" && neighbours != "8")
      throw Failure(fmt::format("a pixel has 4 or 8 neighbours, not '{}'", neighbours));
    const Connectivity connectivity = neighbours == "4" ? Connectivity::four : Connectivity::eight;
    pending_ = FloodFill{in.point("x", "y"), connectivity};
  }

  void sprite(Arguments& in) {
    Sprite sprite;
    const std::string& file = in.word("file").text;
    const Point corner = in.point("x", "y");
    sprite.area = {corner.x, corner.y, 0, 0};
    if (in.left() > 0) {
      sprite.scale = in.subpixel("scale");
      if (sprite.scale < 1 || sprite.scale > 1 << 16) throw Failure("the scale must be 1/256 to 256");
      sprite.angle = intaglio::number::Angle::from_steps(in.whole("angle"));
      sprite.method = chosen(turning_methods);
      if (sprite.method != SpriteMethod::zoom && sprite.scale != linear::subpixel_one)
        throw Failure("by this method a sprite keeps its size: the scale must be 1");
    }
    show(in, std::move(sprite), file);
  }

  void stretch(Arguments& in) {
    Sprite sprite;
    const std::string& file = in.word("file").text;
    sprite.area = in.rectangle();
    sprite.method = chosen(stretching_methods);
    show(in, std::move(sprite), file);
  }

  void show(Arguments& in, Sprite sprite, const std::string& file) {
    in.end();
    sprite.picture = read_sprite(file);
    sprite.palette = canvas_->palette();
    sprite.dither = dither_;
    pending_ = std::move(sprite);
  }

  void dither(Arguments& in) {
    if (in.take("off")) {
      dither_.reset();
      return;
    }
    SpriteDither by{in.one_of("method", dither_methods), last_index() + 1};
    if (in.left() > 0) by.levels = in.whole("levels", 2, last_index() + 1);
    dither_ = by;
  }

  void text(Arguments& in) {
    const Point place = in.point("x", "y");
    const Word& string = in.word("text");
    if (!string.quoted) throw Failure(fmt::format("the text must stand in quotes, not '{}'", string.text));
    Text text{font_, place, string.text};
    if (in.left() > 0) text.alignment = in.one_of("alignment", alignments);
    if (in.left() > 0) text.baseline = in.one_of("base line", baselines);
    pending_ = std::move(text);
  }

  static Circle round(Arguments& in, bool filled) {
    const Point centre = in.point("x", "y");
    return {centre, in.whole("radius"), filled};
  }

  static DiametricCircle diametric(Arguments& in, bool filled) {
    const Point top_left = in.point("x", "y");
    return {top_left, in.whole("diameter"), filled};
  }
  static Ellipse oval(Arguments& in, bool filled) {
    const Point centre = in.point("x", "y");
    const int x_radius = in.whole("x radius");
    return {centre, x_radius, in.whole("y radius"), filled};
  }
  static Arc swept(Arguments& in, SweptShape shape) {
    const Point centre = in.point("x", "y");
    const int radius = in.whole("radius");
    const auto start = intaglio::number::Angle::from_steps(in.whole("start"));
    return {centre, radius, start, in.whole("sweep"), shape};
  }
  static EllipseArc swept_oval(Arguments& in, SweptShape shape) {
    const Point centre = in.point("x", "y");
    const int x_radius = in.whole("x radius");
    const int y_radius = in.whole("y radius");
    const auto start = intaglio::number::Angle::from_steps(in.whole("start"));
    return {centre, x_radius, y_radius, start, in.whole("sweep"), shape};
  }
  static RoundRectangle rounded(Arguments& in, bool filled) {
    const linear::Rect area = in.rectangle();
    auto radii = intaglio::raster::CornerRadii::all(in.whole("radius"));
    if (in.left() > 0) {
      radii.top_right = in.whole("top right radius");
      radii.bottom_right = in.whole("bottom right radius");
      radii.bottom_left = in.whole("bottom left radius");
    }
    return {area, radii, filled};
  }

  void draw() {
    if (method_) throw Failure(fmt::format("no method '{}'; there is only one", *method_));
    const Status status = canvas_->draw(*pending_, pen_);
    pending_.reset();
    if (!status.ok()) throw Failure(in_words(status));
  }

  [[nodiscard]] int last_index() const { return static_cast<int>(canvas_->max_index()); }

  using Method = void (Interpreter::*)(Arguments&);
  static constexpr auto commands = std::to_array<std::pair<std::string_view, Method>>({
      {"surface", &Interpreter::surface},
      {"palette", &Interpreter::palette},
      {"color", &Interpreter::colour},
      {"colour", &Interpreter::colour},
      {"mode", &Interpreter::mode},
      {"aa", &Interpreter::aa},
      {"clip", &Interpreter::clip},
      {"clippoly", &Interpreter::clippoly},
      {"font", &Interpreter::font},
      {"method", &Interpreter::method},
      {"pixel", &Interpreter::pixel},
      {"line", &Interpreter::line},
      {"dash", &Interpreter::dash},
      {"thickline", &Interpreter::thickline},
      {"polyline", &Interpreter::polyline},
      {"rect", &Interpreter::rect},
      {"fillrect", &Interpreter::fillrect},
      {"circle", &Interpreter::circle},
      {"disc", &Interpreter::disc},
      {"evencircle", &Interpreter::evencircle},
      {"evendisc", &Interpreter::evendisc},
      {"ellipse", &Interpreter::ellipse},
      {"fillellipse", &Interpreter::fillellipse},
      {"ring", &Interpreter::ring},
      {"arc", &Interpreter::arc},
      {"pie", &Interpreter::pie},
      {"chord", &Interpreter::chord},
      {"ellipsearc", &Interpreter::ellipsearc},
      {"ellipsepie", &Interpreter::ellipsepie},
      {"ellipsechord", &Interpreter::ellipsechord},
      {"roundrect", &Interpreter::roundrect},
      {"fillroundrect", &Interpreter::fillroundrect},
      {"triangle", &Interpreter::triangle},
      {"polygon", &Interpreter::polygon},
      {"coverage", &Interpreter::coverage},
      {"boolean", &Interpreter::boolean},
      {"flood", &Interpreter::flood},
      {"dither", &Interpreter::dither},
      {"sprite", &Interpreter::sprite},
      {"stretch", &Interpreter::stretch},
      {"text", &Interpreter::text},
  });

  std::shared_ptr<Canvas> canvas_;
  Pen pen_;
  const Font* font_ = &intaglio::fonts::fixed_6x13;
  std::array<std::uint8_t, 3> colours_{};
  std::optional<SpriteDither> dither_;
  std::optional<std::string> method_;  // for the next primitive
  std::optional<Primitive> pending_;
};

}  // namespace

std::shared_ptr<const Canvas> draw_program(std::string_view source) {
  Interpreter interpreter;
  std::size_t number = 0;
  while (!source.empty()) {
    ++number;
    const auto end = source.find('\n');
    const std::string_view line = source.substr(0, end);
    source = end == std::string_view::npos ? std::string_view{} : source.substr(end + 1);
    try {
      const std::vector<Word> words = split_words(line);
      if (words.empty()) continue;
      if (words.front().quoted) throw Failure("a command must not stand in quotes");
      interpreter.run(words.front().text, Arguments(std::span(words).subspan(1)));
    } catch (const Failure& failure) {
      throw Failure(fmt::format("line {}: {}", number, failure.what()));
    }
  }
  if (!interpreter.canvas()) throw Failure(fmt::format("line {}: no surface command", number + 1));
  return interpreter.canvas();
}

}  // namespace host::draw
