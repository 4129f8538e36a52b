// SPDX-License-Identifier: MIT
//
// libfixmath side by side with this library: errors, and counts.
//
// Rule: every result is compared with the C library's in long double (64 bits) of the input's exact value,
// each in its own format; errors are in 2^-16 for all, angles in 2^-16 radian.
//   lab-peers-BUILD errors   how far off each is, as JSON
//   lab-peers-BUILD count    to be run by callgrind: the counts of counts.cpp
#include <host/lab/errors/report.hpp>
#include <host/lab/peers/libfixmath.hpp>

#include <nlohmann/json.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <exception>
#include <firmware/lab/count/probe.hpp>
#include <numbers>
#include <random>
#include <string_view>

void count_peers() noexcept;

namespace {

using host::lab::Effort;

constexpr long double pi = std::numbers::pi_v<long double>;
constexpr long double one = 65536;
constexpr std::int64_t random_points = 10'000'000;
constexpr unsigned seed = 20220222;

/// 32 bits, small numbers as likely as large ones.
fix16_t of_any_size(std::mt19937& random) {
  const auto shift = static_cast<unsigned>(random() % 32);
  return static_cast<fix16_t>(static_cast<std::int32_t>(random()) >> shift);
}

/// Numbers about which arithmetic goes wrong: powers of two and their neighbours, of both signs.
template <class Visit>
void visit_edges(Visit&& visit) {
  for (unsigned bit = 0; bit < 31; ++bit) {
    for (std::int64_t near = -1; near <= 1; ++near) {
      visit((std::int64_t{1} << bit) + near);
      visit(-(std::int64_t{1} << bit) + near);
    }
  }
}

template <class PeerFamily, class R>
long double sine_error(std::int64_t x) {
  if constexpr (std::is_invocable_v<R, fix16_t>) {
    const auto radians = static_cast<fix16_t>(x);
    return std::fabs(static_cast<long double>(R{}(radians)) -
                     std::sin(static_cast<long double>(x) / one) * one);
  } else {
    const auto angle = intaglio::number::Angle::from_steps(static_cast<int>(x));
    return std::fabs(static_cast<long double>(R{}(angle).raw()) * 2 -
                     std::sin(pi * static_cast<long double>(angle.signed_steps()) / 32768) * one);
  }
}

struct SineErrors {
  using Family = lab::PeerSine;
  using Case = std::array<std::int64_t, 1>;
  template <class Visit>
  static std::string cases(int /*load*/, Effort /*effort*/, Visit&& visit) {
    for (std::int64_t x = -fix16_pi; x <= fix16_pi; ++x) visit(Case{x});
    return "every angle from -pi to pi";
  }
  template <class R>
  static long double error(int /*load*/, const Case& c) {
    return sine_error<Family, R>(c[0]);
  }
};

struct TurnsErrors {
  using Family = lab::PeerTurns;
  using Case = std::array<std::int64_t, 1>;
  template <class Visit>
  static std::string cases(int /*load*/, Effort effort, Visit&& visit) {
    std::mt19937 random(seed);
    for (std::int64_t i = effort.random(random_points); i > 0; --i) {
      visit(Case{static_cast<std::int32_t>(random())});
    }
    for (int turns = -5215; turns <= 5215; ++turns) {
      visit(Case{std::llround(static_cast<long double>(turns) * 2 * pi * one)});
    }
    return "random angles and all whole turns";
  }
  template <class R>
  static long double error(int /*load*/, const Case& c) {
    return sine_error<Family, R>(c[0]);
  }
};

struct SquareRootErrors {
  using Family = lab::PeerSquareRoot;
  using Case = std::array<std::int64_t, 1>;
  template <class Visit>
  static std::string cases(int load, Effort effort, Visit&& visit) {
    if (load == 0) {
      for (std::int64_t x = 0; x <= fix16_one; ++x) visit(Case{x});
      return "every number from 0 to 1";
    }
    std::mt19937 random(seed);
    for (std::int64_t i = effort.random(random_points); i > 0; --i) {
      visit(Case{fix16_one + static_cast<std::int64_t>(random() % (fix16_maximum - fix16_one))});
    }
    // Squares and half-way between them.
    for (std::int64_t root = 2 * fix16_one; root * root / fix16_one < fix16_maximum - 1; root += 2049) {
      for (std::int64_t near = -1; near <= 1; ++near) visit(Case{root * root / fix16_one + near});
    }
    return "random numbers, and those about squares";
  }
  template <class R>
  static long double error(int /*load*/, const Case& c) {
    const auto x = static_cast<fix16_t>(c[0]);
    return std::fabs(static_cast<long double>(R{}(x)) - std::sqrt(static_cast<long double>(x) * one));
  }
};

struct DivisionErrors {
  using Family = lab::PeerDivision;
  using Case = std::array<std::int64_t, 2>;
  template <class Visit>
  static std::string cases(int load, Effort effort, Visit&& visit) {
    // The least number, too, is an operand; a quotient that overflows isn't looked at.
    const auto visit_fitting = [&visit](std::int64_t a, std::int64_t b) {
      if (b != 0 && std::abs(a * fix16_one) < std::abs(b) * fix16_maximum) visit(Case{a, b});
    };
    std::mt19937 random(seed);
    const auto length = [&random] { return static_cast<std::int64_t>(random() % (320 * 65536U)); };
    for (std::int64_t i = effort.random(random_points); i > 0; --i) {
      if (load == 0) {
        const std::int64_t a = length();
        visit_fitting(a, 65536 + length() % (319 * 65536));
      } else {
        const fix16_t a = of_any_size(random);
        visit_fitting(a, of_any_size(random));
      }
    }
    if (load == 0) return "random lengths";
    visit_edges([&](std::int64_t a) { visit_edges([&](std::int64_t b) { visit_fitting(a, b); }); });
    return "random numbers of all sizes, and all pairs of those about powers of two";
  }
  template <class R>
  static long double error(int /*load*/, const Case& c) {
    const auto [a, b] = c;
    const long double exact = static_cast<long double>(a) * one / static_cast<long double>(b);
    return std::fabs(static_cast<long double>(R{}(static_cast<fix16_t>(a), static_cast<fix16_t>(b))) - exact);
  }
};

struct ArcTangentErrors {
  using Family = lab::PeerArcTangent;
  using Case = std::array<std::int64_t, 2>;
  template <class Visit>
  static std::string cases(int /*load*/, Effort effort, Visit&& visit) {
    std::mt19937 random(seed);
    const auto length = [&random] {
      return static_cast<std::int64_t>(random() % (640 * 65536U + 1)) - 320 * 65536;
    };
    for (std::int64_t i = effort.random(random_points); i > 0; --i) {
      const std::int64_t y = length();
      visit(Case{y, length()});
    }
    for (std::int64_t y = -160; y <= 160; ++y) {
      for (std::int64_t x = -160; x <= 160; ++x) {
        if (x != 0 || y != 0) visit(Case{y * fix16_one, x * fix16_one});
      }
    }
    return "random vectors, and all of whole numbers up to 160";
  }
  template <class R>
  static long double error(int /*load*/, const Case& c) {
    const auto [y, x] = c;
    const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    const auto across = static_cast<fix16_t>(x);
    const auto down = static_cast<fix16_t>(y);
    long double found = 0;
    if constexpr (std::is_same_v<R, lab::Fix16Atan2>) {
      found = static_cast<long double>(R{}(down, across)) / one;
    } else {
      found = static_cast<long double>(R{}(across, down).steps()) * (2 * pi) / 65536;
    }
    return std::fabs(std::remainder(found - exact, 2 * pi)) * one;  // pi and -pi are the same direction
  }
};

template <class E>
void add_errors(nlohmann::ordered_json& json, Effort effort) {
  const auto family = host::lab::report<E>();
  nlohmann::ordered_json loads;
  for (int load = 0; load < static_cast<int>(family.loads.size()); ++load) {
    nlohmann::ordered_json rungs;
    for (const auto& rung : family.rungs) {
      const auto found = rung.measure(load, effort);
      rungs.push_back({{"name", rung.name},
                       {"worst", static_cast<double>(found.worst)},
                       {"mean", static_cast<double>(found.mean)},
                       {"worst_input", found.worst_input},
                       {"points", found.points},
                       {"how", found.how}});
    }
    const auto& described = family.loads[static_cast<std::size_t>(load)];
    loads.push_back({{"name", described.name}, {"calls", described.calls}, {"rungs", rungs}});
  }
  json.push_back({{"name", family.name},
                  {"title", family.title},
                  {"type", lab::number::type_name<typename E::Family>()},
                  {"loads", loads}});
}

}  // namespace

int main(int argc, char** argv) try {
  const std::string_view command = argc > 1 ? argv[1] : "";
  if (command == "count") {
    count_peers();
    lab::probe::finish();
  }
  if (command != "errors") {
    std::fputs("lab-peers: errors [--full], or count\n", stderr);
    return 2;
  }
  const Effort effort(argc > 2 && std::string_view(argv[2]) == "--full");
  nlohmann::ordered_json json;
  add_errors<SineErrors>(json, effort);
  add_errors<TurnsErrors>(json, effort);
  add_errors<SquareRootErrors>(json, effort);
  add_errors<DivisionErrors>(json, effort);
  add_errors<ArcTangentErrors>(json, effort);
  std::puts(json.dump(1).c_str());
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "lab-peers: %s\n", e.what());
  return 1;
}
