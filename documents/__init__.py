"""What the documents and the programs that measure for them share."""
