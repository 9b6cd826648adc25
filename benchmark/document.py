"""Tables of figures in a document, between the lines <!-- NAME --> and <!-- end of NAME -->."""


def marks(name):
    return f'<!-- {name} -->', f'<!-- end of {name} -->'


def require_place(parser, path, name):
    """Ends the program, before it measures anything, where the document has no place for the table."""
    begin, end = marks(name)
    if not path.is_file() or end not in path.read_text(encoding='utf-8').partition(begin)[2]:
        parser.error(f'{path} has no lines {begin} and {end}')


def put(path, name, text):
    begin, end = marks(name)
    before, _, rest = path.read_text(encoding='utf-8').partition(begin)
    after = rest.partition(end)[2]
    path.write_text(f'{before}{begin}\n{text.rstrip()}\n{end}{after}', encoding='utf-8')
