"""Tables within a page of the documentation, between <!-- NAME: made by ... --> and <!-- end -->."""
import re


def table(heading, rows):
    lines = ['| ' + ' | '.join(row) + ' |' for row in [heading] + rows]
    lines.insert(1, '|' + '---|' * len(heading))
    return '\n'.join(lines) + '\n'


def number(value, digits):
    text = f'{value:.{digits}f}'
    return text[1:] if digits > 2 and text.startswith('0.') else text


def replace(path, tables):
    """Puts {name: text} in their places; what stands around them stays."""
    with open(path) as file:
        page = file.read()
    for name, text in tables.items():
        pattern = re.compile(rf'(<!-- {re.escape(name)}: .*? -->\n).*?(<!-- end -->)', re.S)
        assert pattern.search(page), f'{path} has no place for {name}'
        page = pattern.sub(lambda match: match[1] + '\n' + text + '\n' + match[2], page)
    with open(path, 'w') as file:
        file.write(page)
    print(path + ': made')
