// SPDX-License-Identifier: MIT
//
// The preview on a terminal. It draws on the alternate screen, so what was there comes back.
#include <host/failure.hpp>
#include <host/sim/half_blocks.hpp>
#include <host/sim/viewer.hpp>

#include <poll.h>
#include <string_view>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace host {

namespace {

constexpr std::string_view enter_screen = "\x1b[?1049h\x1b[?25l\x1b[2J";
constexpr std::string_view leave_screen = "\x1b[0m\x1b[?25h\x1b[?1049l";

termios modes_before{};
bool modes_changed = false;

/// Writes all of it. What a terminal doesn't take is lost, which does no harm.
void write_out(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(STDOUT_FILENO, text.data(), text.size());
    if (written <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void restore() {
  write_out(leave_screen);
  if (modes_changed) tcsetattr(STDIN_FILENO, TCSANOW, &modes_before);
}

class Terminal final : public Viewer {
 public:
  Terminal() {
    if (tcgetattr(STDIN_FILENO, &modes_before) == 0) {
      termios raw = modes_before;
      raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
      raw.c_cc[VMIN] = 0;
      raw.c_cc[VTIME] = 0;
      modes_changed = tcsetattr(STDIN_FILENO, TCSANOW, &raw) == 0;
    }
    write_out(enter_screen);
  }
  ~Terminal() override { restore(); }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  bool show(const RgbPicture& picture) override {
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row < 2)
      size = {24, 80, 0, 0};
    if (size.ws_col != last_.ws_col || size.ws_row != last_.ws_row) write_out("\x1b[2J");
    last_ = size;
    write_out("\x1b[H" + half_blocks(shrink_to_fit(picture, size.ws_col, size.ws_row - 1)) +
              "Press any key to end.");
    return !key_pressed();
  }

 private:
  [[nodiscard]] static bool key_pressed() {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    char key = 0;
    return modes_changed && poll(&input, 1, 0) > 0 && read(STDIN_FILENO, &key, 1) > 0;
  }

  winsize last_{};
};

}  // namespace

bool terminal_possible() { return isatty(STDOUT_FILENO) == 1; }

std::unique_ptr<Viewer> open_terminal() {
  if (!terminal_possible()) throw Failure("--terminal: standard output is no terminal");
  return std::make_unique<Terminal>();
}

}  // namespace host
