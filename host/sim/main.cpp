// SPDX-License-Identifier: MIT
#include <host/sim/simulation.hpp>

#include <exception>
#include <iostream>

int main(int argc, char** argv) {
  try {
    const auto parsed = host::parse_command_line(argc, argv);
    if (const int* const exit_code = std::get_if<int>(&parsed)) return *exit_code;
    const host::Options& options = std::get<host::Options>(parsed);
    if (options.list)
      host::list_all(std::cout);
    else if (options.list_panels)
      host::list_panels(std::cout);
    else if (host::means_attached(options.attach))
      host::run_on_real_panel(options);
    else
      host::simulate(options);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "intaglio-sim: " << error.what() << '\n';
    return 1;
  }
}
