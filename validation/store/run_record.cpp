// SPDX-License-Identifier: BSD-3-Clause
// The words for the status of a run.
#include "validation/store/run_record.hpp"

#include "solver/core/errors.hpp"

namespace wetdeck {

std::string to_string(RunStatus status) {
    switch (status) {
        case RunStatus::ok:
            return "ok";
        case RunStatus::unstable:
            return "unstable";
        case RunStatus::failed:
            return "failed";
    }
    throw DataError("run status out of range");
}

RunStatus run_status_from(const std::string& text) {
    for (const RunStatus status : {RunStatus::ok, RunStatus::unstable, RunStatus::failed}) {
        if (text == to_string(status)) return status;
    }
    throw DataError("run status is '" + text + "', expected ok, unstable or failed");
}

}  // namespace wetdeck
