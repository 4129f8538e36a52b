@ SPDX-License-Identifier: MIT
@
@ Start-up of an ARM926 board: exception vectors, stacks of the IRQ and supervisor modes, .bss, main.
@ The instruction set is Arm throughout; the image is loaded whole, so .data needs no copying.
        .section .vectors, "ax", %progbits
        .arm
        .global start
vectors:
        b       start
        b       fault           @ undefined instruction
        b       fault           @ supervisor call
        b       fault           @ prefetch abort
        b       fault           @ data abort
        b       fault           @ reserved
        b       irq
        b       fault           @ FIQ

start:
        msr     cpsr_c, #0xd2   @ IRQ mode, interrupts masked
        ldr     sp, =link_irq_stack_top
        msr     cpsr_c, #0xd3   @ supervisor mode, interrupts masked
        ldr     sp, =link_stack_top
        ldr     r0, =link_bss_begin
        ldr     r1, =link_bss_end
        mov     r2, #0
1:      cmp     r0, r1
        strlo   r2, [r0], #4
        blo     1b
        bl      main
2:      b       2b

irq:
        sub     lr, lr, #4      @ the interrupted instruction
        stmfd   sp!, {r0-r3, r12, lr}
        bl      handle_irq
        ldmfd   sp!, {r0-r3, r12, pc}^

fault:
        msr     cpsr_c, #0xd3
        ldr     sp, =link_stack_top
        bl      handle_fault
3:      b       3b
        .ltorg
