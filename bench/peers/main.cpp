#include "peer.h"
#include "usage.h"

#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <new>

namespace {

// The codes of foldless, as far as they apply.
constexpr int done = 0;
constexpr int failed = 1;
constexpr int wrong_usage = 2;
constexpr int out_of_memory = 7;

struct Counts {
    std::size_t asked;
    std::size_t in;
    std::size_t out;
};

// One line; the keys are those of foldless's report.
void print(const Counts& faces, const Instant (&at)[3], std::size_t memory) {
    std::printf("{\"input\": {\"faces\": %zu}, \"output\": {\"faces\": %zu}, \"stop_reason\": \"%s\", "
                "\"cpu_seconds\": {\"setup\": %.6f, \"decimate\": %.6f}, "
                "\"seconds\": {\"setup\": %.6f, \"decimate\": %.6f}, \"peak_memory_bytes\": %zu}\n",
                faces.in, faces.out, faces.out <= faces.asked ? "target_reached" : "no_further",
                at[1].cpu_seconds - at[0].cpu_seconds, at[2].cpu_seconds - at[1].cpu_seconds,
                at[1].seconds - at[0].seconds, at[2].seconds - at[1].seconds, memory);
}

void run(const char* input, const char* output, std::size_t asked) {
    PlainMesh scan = read_plain_ply(input);
    Counts faces{asked, scan.faces.size(), 0};

    const Instant start = now();
    const std::unique_ptr<Peer> peer = make_peer(scan);
    scan = {}; // the library has its own
    const Instant built = now();
    peer->decimate(asked);
    const Instant decimated = now();

    const std::size_t memory = peak_memory_bytes();
    const PlainMesh result = peer->result();
    write_plain_ply(output, result);
    faces.out = result.faces.size();
    print(faces, {start, built, decimated}, memory);
}

bool read_count(const char* text, std::size_t& count) {
    const char* const end = text + std::strlen(text);
    const auto [stop, error] = std::from_chars(text, end, count);
    return error == std::errc() && stop == end;
}

} // namespace

int main(int argc, char** argv) {
    std::size_t faces = 0;
    if (argc != 4 || !read_count(argv[3], faces)) {
        std::fprintf(stderr, "usage: %s IN.ply OUT.ply FACES\n", argv[0]);
        return wrong_usage;
    }
    try {
        run(argv[1], argv[2], faces);
        return done;
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "out of memory\n");
        return out_of_memory;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return failed;
    }
}
