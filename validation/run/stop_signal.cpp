// SPDX-License-Identifier: BSD-3-Clause
#include "validation/run/stop_signal.hpp"

#include <csignal>

namespace wetdeck {
namespace {

volatile std::sig_atomic_t received = 0;

extern "C" void note_signal(int number) {
    received = number;
}

}  // namespace

void catch_stop_signals() {
    for (const int number : {SIGINT, SIGTERM}) {
        struct sigaction before {};
        sigaction(number, nullptr, &before);
        if (before.sa_handler == SIG_IGN) continue;
        struct sigaction action {};
        action.sa_handler = note_signal;
        action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
        sigaction(number, &action, nullptr);
    }
}

int stop_signal() {
    return received;
}

Interrupted::Interrupted(int signal_number, const std::string& how_to_go_on)
    : std::runtime_error(std::string("stopped by ") + (signal_number == SIGINT ? "SIGINT" : "SIGTERM") +
                         how_to_go_on),
      signal_(signal_number) {}

}  // namespace wetdeck
