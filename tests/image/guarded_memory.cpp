// SPDX-License-Identifier: MIT
//
// Nothing outside a source or a mask is ever read, and nothing outside a target written: their memory touches
// pages that no one may touch.
#include <tests/image/every_blit.hpp>
#include <tests/image/pictures.hpp>

#include <sys/mman.h>
#include <unistd.h>

namespace {

using namespace intaglio;
using image::ColourKey;
using image::Indexed1;
using image::Indexed4;
using image::Indexed8;
using image::Masked;
using image::Picture;
using image::Surface;

/// Bytes that begin or end at a forbidden page.
class GuardedBytes {
 public:
  GuardedBytes(std::size_t size, bool at_begin)
      : size_(size), page_(static_cast<std::size_t>(getpagesize())) {
    middle_ = (size + page_ - 1) / page_ * page_;
    void* const all = mmap(nullptr, middle_ + 2 * page_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (all == MAP_FAILED) return;
    base_ = static_cast<std::uint8_t*>(all);
    std::uint8_t* const usable = base_ + page_;
    if (mprotect(usable, middle_, PROT_READ | PROT_WRITE) != 0) return;
    bytes_ = at_begin ? usable : usable + (middle_ - size);
  }
  ~GuardedBytes() {
    if (base_ != nullptr) munmap(base_, middle_ + 2 * page_);
  }
  GuardedBytes(const GuardedBytes&) = delete;
  GuardedBytes& operator=(const GuardedBytes&) = delete;

  [[nodiscard]] bool ok() const { return bytes_ != nullptr; }
  [[nodiscard]] std::span<std::uint8_t> span() const { return {bytes_, size_}; }

 private:
  std::size_t size_;
  std::size_t page_;
  std::size_t middle_ = 0;
  std::uint8_t* base_ = nullptr;
  std::uint8_t* bytes_ = nullptr;
};

template <class F, class G>
void expect_no_step_outside(bool at_begin) {
  oracle::Random random(91);
  for (int i = 0; i < 60; ++i) {
    const linear::Size target_size{random.between(1, 40), random.between(1, 30)};
    const linear::Size source_size{random.between(1, 25), random.between(1, 25)};
    const auto bytes_of = [](int row_bytes, int rows) { return static_cast<std::size_t>(row_bytes * rows); };
    const GuardedBytes to(bytes_of(F::row_bytes(target_size.width), target_size.height), at_begin);
    const GuardedBytes from(bytes_of(G::row_bytes(source_size.width), source_size.height), at_begin);
    const GuardedBytes mask(bytes_of(Indexed1::row_bytes(source_size.width), source_size.height), at_begin);
    ASSERT_TRUE(to.ok() && from.ok() && mask.ok());
    const auto target = Surface<F>::over(to.span(), target_size);
    const auto source = Picture<G>::over(from.span(), source_size);
    const auto holes = Picture<Indexed1>::over(mask.span(), source_size);
    ASSERT_TRUE(target.ok() && source.ok() && holes.ok());
    for (std::uint8_t& byte : mask.span()) byte = static_cast<std::uint8_t>(random.bits());
    for (int j = 0; j < 10; ++j)
      tests::with_each_blit(random, target_size, source_size, [&](auto draw) {
        ASSERT_TRUE(draw(target.value(), source.value(), image::Everything{}).ok());
        ASSERT_TRUE(draw(target.value(), source.value(), ColourKey{1}).ok());
        ASSERT_TRUE(draw(target.value(), source.value(), Masked{holes.value()}).ok());
      });
  }
}

// A read outside ends the program.
TEST(GuardedMemory, IsNeverLeftByAnyBlit) {
  for (const bool at_begin : {false, true}) {
    expect_no_step_outside<Indexed8, Indexed8>(at_begin);
    expect_no_step_outside<Indexed4, Indexed4>(at_begin);
    expect_no_step_outside<Indexed8, Indexed1>(at_begin);
    expect_no_step_outside<Indexed1, Indexed1>(at_begin);
  }
}

}  // namespace
