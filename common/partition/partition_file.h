#pragma once

#include "common/partition/partition.h"

#include <cstdint>
#include <filesystem>

namespace hipmap {

/// The length to which a chunk of a file grows.
inline constexpr std::size_t kChunkBytes = std::size_t{1} << 25;

/// Writes `partition` as a .hpm file (docs/partition_file.md): to a temporary name, synced,
/// renamed. Throws InputError if the file cannot be written; then no file is left behind.
/// chunk_bytes: from 1 to kChunkBytes.  Memory: a few chunks.  Chunks are packed by all threads
/// while others are written.
void write_partition(const std::filesystem::path& path, const Partition& partition,
                     std::size_t chunk_bytes = kChunkBytes);

/// Reads a .hpm file, a chunk at a time, and checks every value in it: sizes, ranges of ids, edges
/// that point back. Throws InputError if there is no such file, or it is truncated, damaged or of
/// another version of the format.
Partition read_partition(const std::filesystem::path& path);

/// Returns a 64-bit checksum of every field, which also detects damage that leaves each number
/// plausible.
std::uint64_t partition_checksum(const Partition& partition);

/// Throws InputError, naming `path`, unless `partition` was made from this scene.
void check_partition_of(const Partition& partition, const Scene& scene,
                        const std::filesystem::path& path);

/// Stores faces of the scene of a partition where the partition expects them (set_apart).  Throws
/// InputError, naming `path`, if its copies are not those of the scene.
void set_apart_for(const Partition& partition, TriangleMesh& mesh,
                   const std::filesystem::path& path);

} // namespace hipmap
