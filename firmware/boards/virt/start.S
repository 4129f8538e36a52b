# SPDX-License-Identifier: MIT
#
# Start-up of a RISC-V board in machine mode: trap vector, stack, .bss, main. Only hart 0 runs.
        .section .start, "ax", @progbits
        .global start
start:
        csrr    t0, mhartid
        bnez    t0, 3f
        la      t0, fault
        csrw    mtvec, t0
        la      sp, link_stack_top
        la      t0, link_bss_begin
        la      t1, link_bss_end
1:      bgeu    t0, t1, 2f
        sw      zero, 0(t0)
        addi    t0, t0, 4
        j       1b
2:      call    main
3:      wfi
        j       3b

        .align  2
fault:  la      sp, link_stack_top
        call    handle_fault
        j       3b
