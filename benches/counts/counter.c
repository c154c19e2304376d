/* A plugin of QEMU's user mode that counts instructions between calls of one function of the guest.
 *
 *     qemu-aarch64 -plugin counter.so,mark=ADDRESS,out=FILE PROGRAM
 *
 * The calls come in threes: before a short run, before a long one, and after it. For each three the file gets, in
 * words of 64 bits, the instructions of either run, the number of blocks that the long one went through, and those
 * blocks in order: the address of the first instruction, and in the upper 16 bits how many there are.
 *
 * A block is what QEMU translates at once, and is left only by its last instruction, if nothing traps. What is
 * declared here is QEMU's interface for plugins, for which Debian has no header. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct qemu_plugin_tb;
typedef uint64_t qemu_plugin_id_t;
void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t, void (*)(qemu_plugin_id_t, struct qemu_plugin_tb *));
void qemu_plugin_register_vcpu_tb_exec_cb(struct qemu_plugin_tb *, void (*)(unsigned, void *), int, void *);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *);
uint64_t qemu_plugin_tb_vaddr(const struct qemu_plugin_tb *);

/* The version of the interface: the compiler's command line has it. */
__attribute__((visibility("default"))) int qemu_plugin_version = VERSION;

static uint64_t mark;
static FILE *out;
/* How many calls of three there have been, and the instructions since the last. */
static unsigned calls;
static uint64_t instructions, shorter;
static uint64_t *blocks;
static size_t count, room;

static void marked(void) {
    if (calls == 1) {
        shorter = instructions;
        count = 0;
    } else if (calls == 2) {
        uint64_t head[3] = {shorter, instructions, count};
        fwrite(head, sizeof *head, 3, out);
        fwrite(blocks, sizeof *blocks, count, out);
        fflush(out);
    }
    instructions = 0;
    calls = (calls + 1) % 3;
}

static void executed(unsigned cpu, void *data) {
    (void)cpu;
    uint64_t block = (uint64_t)(uintptr_t)data;
    if ((block & 0xffffffffffff) == mark)
        marked();
    instructions += block >> 48;
    if (calls != 2)
        return;
    if (count == room) {
        room = room ? 2 * room : 1 << 20;
        blocks = realloc(blocks, room * sizeof *blocks);
        if (!blocks)
            abort();
    }
    blocks[count++] = block;
}

static void translated(qemu_plugin_id_t id, struct qemu_plugin_tb *block) {
    (void)id;
    uint64_t packed = qemu_plugin_tb_vaddr(block) | (uint64_t)qemu_plugin_tb_n_insns(block) << 48;
    /* 0: no registers are read. */
    qemu_plugin_register_vcpu_tb_exec_cb(block, executed, 0, (void *)(uintptr_t)packed);
}

__attribute__((visibility("default"))) int qemu_plugin_install(qemu_plugin_id_t id, const void *info, int argc, char **argv) {
    (void)info;
    for (int i = 0; i < argc; i++) {
        if (!strncmp(argv[i], "mark=", 5))
            mark = strtoull(argv[i] + 5, NULL, 0);
        else if (!strncmp(argv[i], "out=", 4))
            out = fopen(argv[i] + 4, "wb");
    }
    if (!mark || !out)
        return -1;
    qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
    return 0;
}
