// SPDX-License-Identifier: MIT
//
// The swap of frames between main loop, VBLANK interrupt and the interrupt at the end of a transfer, through
// all interleavings of up to four frames.
//
// What runs here is the code of boards: present::SwapChain over GuardedSwapControl, hal::SwapProtocol,
// hal::baremetal::TransferPanel and sleep_until. Only the cells that program and interrupts share, the core
// and the glass are of the test: before each access of the program to a cell, and before each half of a frame
// it draws, any interrupt may come. Watched at every step: nothing is drawn on the buffer on display or in
// transfer; what is shown is a whole frame in its own colours; no frame is lost or shown out of order; nobody
// sleeps through what he waits for, or for ever; the counts are those of what was seen. Without any one of
// the guards, something of that is found.
#include <hal/baremetal/transfer_panel.hpp>
#include <hal/swap_protocol.hpp>
#include <intaglio/present/swap_chain.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/present/explorer.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace {

using hal::Feed;
using intaglio::image::Indexed8;
using intaglio::present::Late;
using intaglio::present::Order;
using intaglio::present::Pace;
using intaglio::present::SwapChain;

constexpr int frames = 4;
constexpr std::size_t entries = 2;
constexpr int most_buffers = 3;
/// VBLANKs that come uncalled for, beside those that the program waits for.
struct AtWill {
  int scanning = 4;
  int sending = 2;
};
// More VBLANKs than any wait may last.
constexpr int for_ever = 12;

/// The guards as switches.
struct Switches {
  static inline bool withdraws = true;
  static inline bool publishes_last = true;
  static inline bool joins_colours = true;
  static inline bool asks_first = true;
  static inline bool notes_buffer = true;
  static inline bool takes_back = true;
  static inline bool one_at_a_time = true;
  static inline bool spares_displayed = true;
  static inline bool spares_pending = true;
  static inline bool asks_in_order = true;
  static inline bool waits_for_swap = true;
  static inline bool keeps_colours = true;
  static inline bool masks = true;
};

/// Colours that frame `n` brings: all, one, none or all.
std::size_t colours_of(int n) { return n == 2 ? 1 : n == 3 ? 0 : entries; }
std::uint8_t colour_of(int n, std::size_t entry) {
  return static_cast<std::uint8_t>(n * 16) + static_cast<std::uint8_t>(entry);
}
/// The colour that an entry has when frame `n` is shown, whether or not those before it were.
std::uint8_t expected_colour(int n, std::size_t entry) {
  while (n > 0 && colours_of(n) <= entry) --n;
  return n == 0 ? std::uint8_t{0} : colour_of(n, entry);
}

/// Hardware and watchman.
class World {
 public:
  World(Feed fed, int buffer_count, Order order, Late late, int vblanks_at_will)
      : feed(fed), buffers(buffer_count), order_(order), late_(late), all_at_will_(vblanks_at_will) {}

  void fail(const std::string& what) {
    if (failure.empty()) failure = what;
  }

  // The program's side.

  /// Before a step of the program: any interrupt may come, or several.
  void step() {
    if (in_interrupt) return;
    ++steps_;
    while (failure.empty()) {
      const int choice = explorer.choose(possible(true), [this] { return state(); });
      if (choice == 0) return;
      raise(choice);
    }
  }
  void loaded(std::uint64_t value) {
    if (!in_interrupt) loads_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  /// A new call into the library; `control` is the state of what it keeps from call to call.
  void begin_call(std::string control) {
    ++call_;
    steps_ = 0;
    slept_ = 0;
    loads_.clear();
    control_ = std::move(control);
  }
  void draw(const intaglio::image::Surface<Indexed8>& surface, int x, int n) {
    step();
    const auto before = memory;
    surface.set(x, 0, static_cast<unsigned>(n));
    for (std::size_t i = 0; i < memory.size(); ++i) {
      const int buffer = static_cast<int>(i / 2);
      if (memory[i] != before[i] && buffer == (feed == Feed::scans_out ? displayed_ : sending_))
        fail("frame " + std::to_string(n) + " is drawn on a buffer in use");
    }
  }
  void mask() { masked_ = Switches::masks; }
  void unmask() {
    masked_ = false;
    for (const int interrupt : {1, 2})
      if (std::exchange(waiting_[static_cast<std::size_t>(interrupt)], false)) run(interrupt);
  }
  /// Sleeps until an interrupt comes.
  void sleep(const std::function<bool()>& awake) {
    step();  // one instruction before
    if (!failure.empty()) return end();
    if (waiting_[1] || waiting_[2]) return;
    in_interrupt = true;
    if (awake()) fail("what was waited for had happened before the core went to sleep");
    in_interrupt = false;
    if (++slept_ > for_ever) fail("the program waits for ever");
    if (!failure.empty()) return end();
    raise(explorer.choose(possible(false), [this] { return state() + 's'; }));
  }

  // The hardware's side.

  void load_colour(std::size_t entry, std::uint8_t colour) { colours_[entry] = colour; }
  /// Puts a buffer on display, or begins to send it.
  void latch(int buffer) {
    if (feed == Feed::scans_out) {
      displayed_ = buffer;
      return;
    }
    if (sending_ >= 0) fail("a transfer is begun while another goes on");
    sending_ = buffer;
    age_ = 0;
    see(buffer);
  }

  /// The frame on display; counts it.
  void see(int buffer) {
    const int n = memory[static_cast<std::size_t>(2 * buffer)];
    const std::string frame = "frame " + std::to_string(n);
    if (n != memory[static_cast<std::size_t>(2 * buffer + 1)]) fail(frame + " is shown half drawn");
    for (std::size_t i = 0; i < entries; ++i)
      if (colours_[i] != expected_colour(n, i)) fail(frame + " is shown in another's colours");
    if (n == seen_) return;
    if (n < seen_) fail(frame + " is shown after a later one");
    if (n > seen_ + 1 && order_ == Order::every && late_ == Late::show)
      fail("a frame before " + frame + " was lost");
    seen_ = n;
    ++shown;
  }

  [[nodiscard]] int seen() const { return seen_; }
  [[nodiscard]] bool transferring() const { return sending_ >= 0; }

  Feed feed;
  int buffers;
  std::function<void()> on_vblank;
  std::function<void()> on_sent;
  std::function<std::string()> shared;  ///< The cells.
  std::array<std::uint8_t, 2 * most_buffers> memory{};
  std::uint32_t shown = 0;
  bool in_interrupt = false;
  std::string failure;
  explore::Explorer explorer;

  void start() {
    memory = {};
    shown = 0;
    failure.clear();
    colours_ = {};
    displayed_ = 0;
    sending_ = -1;
    age_ = 0;
    seen_ = 0;
    at_will_ = all_at_will_;
    masked_ = false;
    waiting_ = {};
    call_ = 0;
    ends_ = 0;
  }

 private:
  /// Lets a program that failed come to its end.
  void end() {
    if (++ends_ > 1'000) {
      std::fprintf(stderr, "%s, and then it doesn't end\n", failure.c_str());
      std::abort();
    }
    in_interrupt = true;
    on_sent();
    on_vblank();
    in_interrupt = false;
  }
  /// 1: the program goes on; 2: VBLANK; 4: the transfer has ended. A transfer lasts two VBLANKs at most.
  [[nodiscard]] unsigned possible(bool awake) const {
    unsigned can = awake ? 1U : 0U;
    const bool due = sending_ < 0 || age_ < 2;
    if (!waiting_[1] && due && (!awake || at_will_ > 0)) can |= 2U;
    if (!waiting_[2] && sending_ >= 0) can |= 4U;
    return can;
  }
  void raise(int interrupt) {
    if (interrupt == 1 && at_will_ > 0) --at_will_;
    if (masked_) {
      waiting_[static_cast<std::size_t>(interrupt)] = true;
    } else {
      run(interrupt);
    }
  }
  void run(int interrupt) {
    in_interrupt = true;
    if (interrupt == 1) {
      ++age_;
      on_vblank();
      if (feed == Feed::scans_out) see(displayed_);
    } else {
      see(sending_);  // what has been sent is what was there at the start
      sending_ = -1;
      on_sent();
    }
    in_interrupt = false;
  }
  [[nodiscard]] std::string state() const {
    std::string s = shared() + control_ + loads_;
    for (const int value :
         {call_, steps_, slept_, displayed_, sending_, age_, seen_, at_will_, masked_ ? 1 : 0,
          waiting_[1] ? 1 : 0, waiting_[2] ? 1 : 0, static_cast<int>(shown)})
      s += static_cast<char>(value);
    s.append(memory.begin(), memory.end());
    s.append(colours_.begin(), colours_.end());
    return s;
  }

  Order order_;
  Late late_;
  int all_at_will_;
  std::array<std::uint8_t, entries> colours_{};
  int displayed_ = 0;
  int sending_ = -1;
  int age_ = 0;
  int seen_ = 0;
  int at_will_ = 0;
  bool masked_ = false;
  std::array<bool, 3> waiting_{};
  int call_ = 0;
  int ends_ = 0;
  int steps_ = 0;
  int slept_ = 0;
  std::string loads_;
  std::string control_;
};

World* world = nullptr;

/// A cell whose every access by the program is a step.
template <class T>
class Cell {
 public:
  Cell() = default;
  explicit Cell(T value) : value_(value) {}
  [[nodiscard]] T load() const {
    world->step();
    world->loaded(static_cast<std::uint64_t>(value_));
    return value_;
  }
  void store(T value) {
    world->step();
    value_ = value;
  }

 private:
  T value_{};
};

struct Core {
  static void mask() { world->mask(); }
  static void unmask() { world->unmask(); }
  template <class Done>
  static void wait(const Done& done) {
    world->sleep(done);
  }
};

/// The bytes of an object that lies in memory that was zero.
template <class T>
std::string bytes_of(const T& object) {
  return {reinterpret_cast<const char*>(&object), sizeof object};
}

/// A driver of a panel that scans out, as that of the board clcd is.
class ScannedPanel final : public hal::Panel {
 public:
  ScannedPanel(int buffers, bool knows)
      : capabilities_{.width = 2, .height = 1, .palette_entries = entries, .buffers = buffers},
        knows_(knows) {}

  void on_vblank() {
    protocol_.on_vblank([](int buffer, std::size_t count, const auto& colour) {
      for (std::size_t i = 0; i < count; ++i) world->load_colour(i, colour(i));
      world->latch(buffer);
    });
  }
  void on_sent() {}

 private:
  const hal::Capabilities& do_capabilities() const noexcept override { return capabilities_; }
  std::span<std::uint8_t> do_buffer(int index) noexcept override {
    return std::span(world->memory).subspan(static_cast<std::size_t>(2 * index), 2);
  }
  int do_buffer_stride() const noexcept override { return 2; }
  hal::Status do_show(int index, std::span<const std::uint8_t> palette) noexcept override {
    protocol_.request(index, palette.size() / 3, [palette](std::size_t i) { return palette[3 * i]; });
    return {};
  }
  bool do_show_pending() noexcept override { return protocol_.pending(); }
  bool do_show_replaced() noexcept override { return protocol_.replaced(); }
  int do_on_display() noexcept override { return knows_ ? protocol_.on_display() : unknown; }
  hal::Status do_write(const hal::Rect&, std::span<const std::uint8_t>, int) noexcept override { return {}; }
  hal::Status do_load_palette(std::span<const std::uint8_t>) noexcept override { return {}; }
  std::uint32_t do_vblank_count() noexcept override { return protocol_.vblanks(); }
  hal::Status do_wait_for_vblank() noexcept override {
    const std::uint32_t before = protocol_.vblanks();
    hal::baremetal::sleep_until<Core>([this, before] { return protocol_.vblanks() != before; });
    return world->failure.empty() ? hal::Status{} : hal::Status{hal::Error::timeout, hal::Part::panel};
  }

  hal::Capabilities capabilities_;
  bool knows_;
  hal::SwapProtocol<Cell, std::uint8_t, entries, Feed::scans_out, Switches> protocol_;
};

/// The library's own driver of a panel that is sent its frames.
class SentPanel : private hal::baremetal::FrameTransfer {
 public:
  using Driver = hal::baremetal::TransferPanel<entries, Cell, Core, Switches>;
  SentPanel(int buffers, bool)
      : driver_({.width = 2, .height = 1, .palette_entries = entries}, *this, world->memory, buffers) {}
  operator hal::Panel&() { return driver_; }  // NOLINT(google-explicit-constructor): it stands for it.
  void on_vblank() { driver_.on_vblank(); }
  void on_sent() { driver_.on_sent(); }

 private:
  hal::Status do_begin(std::span<const std::uint8_t> pixels,
                       std::span<const std::uint8_t> colours) noexcept override {
    for (std::size_t i = 0; i < colours.size() / 3; ++i) world->load_colour(i, colours[3 * i]);
    world->latch(static_cast<int>((pixels.data() - world->memory.data()) / 2));
    return {};
  }
  Driver driver_;
};

/// How frames are shown.
struct Policy {
  const char* name;
  Feed feed;
  int buffers;
  Pace pace;
  bool knows = true;  ///< The driver can tell what is on display.
};

/// One run: what is wrong, or nothing.
template <class Driver>
std::string run_once(const Policy& policy) {
  using Chain = SwapChain<Indexed8, intaglio::present::GuardedSwapControl<Switches>>;
  alignas(Driver) static std::array<unsigned char, sizeof(Driver)> driver_memory;
  alignas(Chain) static std::array<unsigned char, sizeof(Chain)> chain_memory;
  driver_memory = {};
  chain_memory = {};
  world->start();
  world->in_interrupt = true;  // Making things isn't a step.
  auto& driver = *new (driver_memory.data()) Driver(policy.buffers, policy.knows);
  hal::Panel& panel = driver;
  auto& chain = *new (chain_memory.data()) Chain(panel, policy.pace);
  world->in_interrupt = false;
  world->on_vblank = [&driver] { driver.on_vblank(); };
  world->on_sent = [&driver] { driver.on_sent(); };
  world->shared = [&driver] { return bytes_of(driver); };
  const auto call = [&chain] { world->begin_call(bytes_of(chain.control())); };

  for (int n = 1; n <= frames; ++n) {
    call();
    auto begun = chain.begin();
    if (!begun.ok()) break;
    call();
    for (const int x : {0, 1}) world->draw(begun.value().surface(), x, n);
    call();
    std::array<std::uint8_t, 3 * entries> palette{};
    for (std::size_t i = 0; i < entries; ++i) palette[3 * i] = colour_of(n, i);
    if (!chain.present(std::move(begun).value(), std::span(palette).first(3 * colours_of(n))).ok()) break;
  }
  call();
  chain.wait_until_shown().ignore();
  while (world->failure.empty() && world->transferring()) panel.wait_for_vblank().ignore();
  if (!world->failure.empty()) return world->failure;
  const auto& counts = chain.counts();
  if (counts.shown + counts.dropped != frames) return "a frame isn't counted";
  if (world->seen() != frames && counts.dropped == 0) return "the last frame isn't shown";
  if (policy.pace.late == Late::show && world->seen() != frames) return "the last frame isn't shown";
  if (counts.shown != world->shown && policy.knows)
    return std::to_string(counts.shown) + " frames are counted, and " + std::to_string(world->shown) +
           " were seen";
  return {};
}

struct Outcome {
  std::string wrong;
  std::size_t states = 0;
};

Outcome explore_all(const Policy& policy, const AtWill& at_will = {}) {
  World here(policy.feed, policy.buffers, policy.pace.order, policy.pace.late,
             policy.feed == Feed::scans_out ? at_will.scanning : at_will.sending);
  world = &here;
  Outcome outcome;
  outcome.wrong = here.explorer.explore([&policy] {
    return policy.feed == Feed::scans_out ? run_once<ScannedPanel>(policy) : run_once<SentPanel>(policy);
  });
  outcome.states = here.explorer.states();
  world = nullptr;
  return outcome;
}

constexpr Pace latest(1, Late::show, Order::latest);
const std::array policies{
    Policy{"two buffers", Feed::scans_out, 2, 1},
    Policy{"three buffers", Feed::scans_out, 3, 1},
    Policy{"the latest of three", Feed::scans_out, 3, latest},
    Policy{"the latest of two", Feed::scans_out, 2, latest},
    Policy{"late frames dropped", Feed::scans_out, 2, Pace(1, Late::drop)},
    Policy{"late frames of three buffers dropped", Feed::scans_out, 3, Pace(1, Late::drop)},
    Policy{"every other VBLANK", Feed::scans_out, 2, 2},
    Policy{"every other VBLANK or never", Feed::scans_out, 3, Pace(2, Late::drop)},
    Policy{"three buffers, display unknown", Feed::scans_out, 3, 1, false},
    Policy{"the latest of three, display unknown", Feed::scans_out, 3, latest, false},
    Policy{"two buffers, sent", Feed::sends, 2, 1},
    Policy{"three buffers, sent", Feed::sends, 3, 1},
    Policy{"the latest of three, sent", Feed::sends, 3, latest},
    Policy{"late frames dropped, sent", Feed::sends, 2, Pace(1, Late::drop)},
};

TEST(Interleavings, OfEveryPolicyShowWholeFramesInTheirColours) {
  for (const Policy& policy : policies) {
    const Outcome outcome = explore_all(policy, oracle::samples(AtWill{}, AtWill{8, 5}));
    EXPECT_EQ(outcome.wrong, "") << policy.name;
    EXPECT_GT(outcome.states, 500U) << policy.name;
    RecordProperty(policy.name, std::to_string(outcome.states));
  }
}

TEST(Interleavings, WithoutAnyOneGuardSomethingIsFound) {
  const std::vector<std::pair<const char*, bool*>> guards{
      {"withdraws", &Switches::withdraws},
      {"publishes_last", &Switches::publishes_last},
      {"joins_colours", &Switches::joins_colours},
      {"asks_first", &Switches::asks_first},
      {"notes_buffer", &Switches::notes_buffer},
      {"takes_back", &Switches::takes_back},
      {"one_at_a_time", &Switches::one_at_a_time},
      {"spares_displayed", &Switches::spares_displayed},
      {"spares_pending", &Switches::spares_pending},
      {"asks_in_order", &Switches::asks_in_order},
      {"waits_for_swap", &Switches::waits_for_swap},
      {"keeps_colours", &Switches::keeps_colours},
      {"masks", &Switches::masks},
  };
  for (const auto& [name, guard] : guards) {
    *guard = false;
    std::string found;
    for (const Policy& policy : policies) {
      const Outcome outcome = explore_all(policy);
      if (outcome.wrong.empty()) continue;
      found = std::string(policy.name) + ": " + outcome.wrong;
      break;
    }
    *guard = true;
    EXPECT_NE(found, "") << "nothing is wrong without " << name;
    RecordProperty(name, found);
  }
}

}  // namespace
