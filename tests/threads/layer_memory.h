// SPDX-License-Identifier: MIT
// How much memory the layer's own code holds. A program that links this has a malloc and a free of its own:
// what is asked for from an address of the layer's gets a mark, by which it is known when it is given back.
// The driver's memory does not count.
#pragma once

namespace threads {

// Looks for the layer among the loaded libraries; false where it is not there. Counts from here on.
bool watch_layer_memory();
// Bytes that the layer has asked for since, less those that it has given back.
long long layer_bytes();

}  // namespace threads
