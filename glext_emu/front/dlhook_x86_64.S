/* SPDX-License-Identifier: MIT
   dlsym and dlopen, put in front of libc's. Both jump to the next one instead of calling it: libc finds its caller by
   the return address, for RTLD_NEXT, RTLD_DEFAULT, RUNPATH and $ORIGIN. The version nodes let an interposer before us
   that asks by dlvsym find us too. */
    .text

    .symver seam_dlsym, dlsym@@GLIBC_2.34, remove
    .symver seam_dlsym_old, dlsym@GLIBC_2.2.5, remove
    .globl seam_dlsym
    .globl seam_dlsym_old
    .type seam_dlsym, @function
    .type seam_dlsym_old, @function
seam_dlsym:
seam_dlsym_old:
    .cfi_startproc
    endbr64
    push %rdi
    .cfi_adjust_cfa_offset 8
    push %rsi
    .cfi_adjust_cfa_offset 8
    sub $8, %rsp
    .cfi_adjust_cfa_offset 8
    call seam_symbol                /* our answer, or null */
    add $8, %rsp
    .cfi_adjust_cfa_offset -8
    pop %rsi
    .cfi_adjust_cfa_offset -8
    pop %rdi
    .cfi_adjust_cfa_offset -8
    test %rax, %rax
    jnz 1f
    mov seam_next_dlsym(%rip), %rax
    jmp *%rax
1:  ret
    .cfi_endproc
    .size seam_dlsym, . - seam_dlsym

    .symver seam_dlopen, dlopen@@GLIBC_2.34, remove
    .symver seam_dlopen_old, dlopen@GLIBC_2.2.5, remove
    .globl seam_dlopen
    .globl seam_dlopen_old
    .type seam_dlopen, @function
    .type seam_dlopen_old, @function
seam_dlopen:
seam_dlopen_old:
    .cfi_startproc
    endbr64
    push %rdi
    .cfi_adjust_cfa_offset 8
    push %rsi
    .cfi_adjust_cfa_offset 8
    sub $8, %rsp
    .cfi_adjust_cfa_offset 8
    call seam_before_dlopen
    add $8, %rsp
    .cfi_adjust_cfa_offset -8
    pop %rsi
    .cfi_adjust_cfa_offset -8
    pop %rdi
    .cfi_adjust_cfa_offset -8
    mov seam_next_dlopen(%rip), %rax
    jmp *%rax
    .cfi_endproc
    .size seam_dlopen, . - seam_dlopen

    .section .note.GNU-stack, "", @progbits
