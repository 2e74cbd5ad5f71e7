" fivecheck.vim - :make checks the program that is being edited, and the quickfix list jumps to what was found.
"
" Put it into ~/.vim/ftplugin/, under the name of your file type for NC programs, or source it:
"     autocmd BufRead *.nc,*.ngc source ~/.vim/fivecheck.vim
" g:fivecheck holds the command without the program.
let &l:makeprg = get(g:, 'fivecheck', 'fivecheck -q -s setup.xml machine.xml') . ' %:S'
" A finding, an error or a warning with or without its column; the indented lines below it belong to it.
let &l:errorformat = '%f:%l:%c: %trror: %m,%f:%l:%c: %tarning: %m,%f:%l: %trror: %m,%f:%l: %tarning: %m,'
let &l:errorformat .= '%-G    %.%#,%-G%.%#'
