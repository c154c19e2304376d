/*
 * Reset of a Cortex-M4F with newlib and semihosting: what a vendor's start-up code does, as short as it
 * can be. The program is a `main` like any other.
 */
#include <stdint.h>
#include <stdlib.h>

extern int main(void);
extern void initialise_monitor_handles(void);
extern uint32_t stack_top;

/* newlib calls these around constructors, of which there are none. */
void _init(void) {}
void _fini(void) {}

void reset(void) {
    /* CPACR: full access to the coprocessors 10 and 11, which are the FPU. */
    *(volatile uint32_t *)0xE000ED88 |= 0xFu << 20;
    __asm__ volatile("dsb\n\tisb");
    initialise_monitor_handles();
    exit(main());
}

/* Any fault ends the run, and not well. */
static void fault(void) { _Exit(3); }

__attribute__((section(".vectors"), used)) static const void *const vectors[16] = {
    &stack_top, (void *)reset, (void *)fault, (void *)fault, (void *)fault, (void *)fault, (void *)fault,
};
