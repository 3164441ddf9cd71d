/* SPDX-License-Identifier: MIT
   dlsym and dlopen, put in front of libc's. Both jump to the next one instead of calling it: libc finds its caller by
   the return address, for RTLD_NEXT, RTLD_DEFAULT, RUNPATH and $ORIGIN. The version nodes let an interposer before us
   that asks by dlvsym find us too. */
    .text

    .symver dlhook_dlsym, dlsym@@GLIBC_2.34, remove
    .symver dlhook_dlsym_old, dlsym@GLIBC_2.2.5, remove
    .globl dlhook_dlsym
    .globl dlhook_dlsym_old
    .type dlhook_dlsym, @function
    .type dlhook_dlsym_old, @function
dlhook_dlsym:
dlhook_dlsym_old:
    .cfi_startproc
    endbr64
    push %rdi
    .cfi_adjust_cfa_offset 8
    push %rsi
    .cfi_adjust_cfa_offset 8
    sub $8, %rsp
    .cfi_adjust_cfa_offset 8
    mov 24(%rsp), %rdx              /* who calls */
    call dlhook_symbol                /* our answer, or null */
    add $8, %rsp
    .cfi_adjust_cfa_offset -8
    pop %rsi
    .cfi_adjust_cfa_offset -8
    pop %rdi
    .cfi_adjust_cfa_offset -8
    test %rax, %rax
    jnz 1f
    mov next_dlsym(%rip), %rax
    jmp *%rax
1:  ret
    .cfi_endproc
    .size dlhook_dlsym, . - dlhook_dlsym

    .symver dlhook_dlopen, dlopen@@GLIBC_2.34, remove
    .symver dlhook_dlopen_old, dlopen@GLIBC_2.2.5, remove
    .globl dlhook_dlopen
    .globl dlhook_dlopen_old
    .type dlhook_dlopen, @function
    .type dlhook_dlopen_old, @function
dlhook_dlopen:
dlhook_dlopen_old:
    .cfi_startproc
    endbr64
    push %rdi
    .cfi_adjust_cfa_offset 8
    push %rsi
    .cfi_adjust_cfa_offset 8
    sub $8, %rsp
    .cfi_adjust_cfa_offset 8
    call dlhook_before_dlopen
    add $8, %rsp
    .cfi_adjust_cfa_offset -8
    pop %rsi
    .cfi_adjust_cfa_offset -8
    pop %rdi
    .cfi_adjust_cfa_offset -8
    mov next_dlopen(%rip), %rax
    jmp *%rax
    .cfi_endproc
    .size dlhook_dlopen, . - dlhook_dlopen

    .section .note.GNU-stack, "", @progbits
